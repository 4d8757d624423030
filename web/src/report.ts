// report.html: puts the parts of the page together.
import { type Acceptance, type DetailLevel, type Fault, type FaultPlace, type Hole, holesOf, type LookAt, type Report, type Water, readReport } from './data';
import { decisionsCommand } from './command';
import { areaText, counted, el, holesText, number } from './dom';
import { areaOf, holesTable, isOfMesh, levelText } from './holes';
import { cellMap } from './map';
import { MARK_NAME, pictureId, pictures } from './pictures';
import { reviewQueue } from './review';
import { warningList } from './warnings';

// The places to look at that are not in the review queue.
function otherLooks(report: Report): LookAt[] {
  const queued = new Set(report.review?.items.flatMap(holesOf));
  return (report.look_at ?? []).filter((look) => !holesOf(look).some((hole) => queued.has(hole)));
}

// The program's verdict: what does not count makes no output partial.
function verdict(report: Report): HTMLElement {
  const { filled, left, counting } = report.verdict;
  const toDecide = report.review?.count ?? 0, looks = otherLooks(report).length;
  const text = left > 0 ? `${counted(filled, 'hole')} filled, ${number(left)} left open`
    : filled > 0 ? `All ${counted(filled, 'hole')} filled` : 'No hole was found';
  const uncounted = report.verdict.uncounted.replace(/^; /, '').replaceAll('m2', 'm\u00b2');
  const next = [report.verdict.chosen ? `${report.verdict.chosen}.` : '', left > 0 ? 'The holes that were left have their reasons in the table.' : '', uncounted ? `${uncounted}.` : '',
    toDecide > 0 ? `${counted(toDecide, 'fill')} to decide on.` : '', looks > 0 ? `${counted(looks, 'place')} to look at.` : ''].filter(Boolean).join(' ');
  return el('div', { class: counting > 0 ? 'verdict open' : 'verdict' }, el('strong', {}, text), ...(next ? [el('span', {}, next)] : []));
}

// What `tilemend check` says of the output.
function acceptance({ accepted, verdict: text, date }: Acceptance): HTMLElement {
  return el('div', { class: accepted ? 'verdict' : 'verdict open' },
    el('strong', {}, text.charAt(0).toUpperCase() + text.slice(1)),
    el('span', {}, `Compared with the scene${date ? ` on ${date}` : ''}.`));
}

function faults(rows: Fault[]): HTMLElement {
  const places = rows.flatMap(({ what, count, places: found }) => {
    const shown: FaultPlace[] = found.length > 0 ? [...found] : [{}], more = count - found.length;
    if (found.length > 0 && more > 0) shown.push({ note: `and ${number(more)} more` });
    return shown.map((place, i) => [
      i === 0 ? what : '', i === 0 ? number(count) : '', String(place.hole ?? ''), (place.cell ?? []).join(', '),
      (place.at ?? []).map((c) => c.toFixed(2)).join(', '), place.note ?? '']);
  });
  return table(['fault', 'count', 'hole', 'cell', 'x, y, z [m]', ''], places, [1]);
}

function facts(report: Report): HTMLElement {
  const area = report.per_hole.reduce((sum, hole) => sum + (hole.filled ? hole.area ?? 0 : 0), 0);
  const rows: [string, string][] = [
    ['cells', number(report.cells.length)],
    ['holes', number(report.hole_count)],
    ['area filled', `${area === 0 ? '0' : area < 1 ? areaText(area, report.per_hole.some(isOfMesh)) : number(area)} m\u00b2`],
    ['waters', number(report.water?.length ?? 0)]];
  if (report.tasks?.tiles_kept) rows.push(['tiles kept', `${number(report.tasks.tiles_kept)} of ${number(report.tasks.tiles)}`]);
  if (report.cleared?.triangles) rows.push(['triangles cleared', number(report.cleared.triangles)]);
  return el('dl', { class: 'facts' }, ...rows.map(([name, value]) => el('div', {}, el('dt', {}, name), el('dd', {}, value))));
}

function table(headings: string[], rows: string[][], numbers: number[] = []): HTMLElement {
  const kind = (i: number) => ({ class: numbers.includes(i) ? 'number' : '' });
  return el('div', { class: 'scroll' }, el('table', {},
    el('thead', {}, el('tr', {}, ...headings.map((text, i) => el('th', kind(i), text)))),
    el('tbody', {}, ...rows.map((row) => el('tr', {}, ...row.map((text, i) => el('td', kind(i), text)))))));
}

// In the words of `tilemend report`: the area is another polygon.
const DECIDERS: Record<string, string> = { area: 'polygon' };

function waters(rows: Water[]): HTMLElement {
  return table(['water', 'kind', 'level [m]', 'sigma [m]', 'area [m\u00b2]', 'cells', 'decided by'],
    rows.map((w) => [String(w.body), w.kind, levelText(w.level_m), number(w.sigma_m, 3), areaText(w.area_m2),
      number(w.cells), DECIDERS[w.decided_by] ?? w.decided_by]), [2, 3, 4, 5]);
}

function looks(rows: LookAt[], holes: Hole[]): HTMLElement {
  const hole = new Map(holes.map((h) => [h.id, h]));
  return table(['hole', 'cell', 'x, y [m]', 'area [m\u00b2]', 'why'],
    rows.map((r) => [holesText(r), (r.cell ?? []).join(', '), (r.centre ?? []).map((c) => c.toFixed(1)).join(', '),
      !r.area_m2 && hole.has(r.hole ?? -1) ? areaOf(hole.get(r.hole!)!) : areaText(r.area_m2), r.why ?? '']), [3]);
}

function levels(rows: DetailLevel[]): HTMLElement {
  return table(['level, 0 the coarsest', 'nodes', 'nodes filled', 'triangles added', 'triangles removed'],
    rows.map((r) => [r.level, r.nodes, r.filled, r.added, r.removed].map((n) => number(n))), [0, 1, 2, 3, 4]);
}

function section(title: string, ...content: HTMLElement[]): HTMLElement {
  return el('section', {}, el('h2', {}, title), ...content);
}

const HOW_TO_LOOK = [el('span', { class: 'hint' }, 'Drag to turn, click and use the wheel to zoom. '),
  `\u201cMarked\u201d shows new surface in ${MARK_NAME}.`];
const LEAST_AREA = 0.5; // m2, of a fill with a picture: kLeastArea in client/page_pictures.cc

function whyNoPictures(report: Report): string {
  const largest = report.per_hole.reduce((most, hole) => (hole.filled ? Math.max(most, hole.area ?? 0) : most), -1);
  const size = areaText(largest, report.per_hole.some(isOfMesh)).replace('<', 'less than');
  if (largest < 0) return 'There is no picture, as no hole was filled.';
  if (largest < LEAST_AREA) return `There is no picture, as all fills are smaller than ${LEAST_AREA} m\u00b2: the largest has ${size} m\u00b2.`;
  return report.picture_problems.length > 0 ? 'There is no picture, as the tiles could not be read:'
    : 'There is no picture, as no new surface was found at the places of the largest fills.';
}

function options(report: Report): HTMLElement {
  const rows = Object.entries(report.options ?? {}).map(([name, value]) => [`--${name}`, String(value)]);
  return el('details', {}, el('summary', {}, 'Options of this run'), table(['option', 'value'], rows));
}

function build(report: Report): HTMLElement[] {
  const review = report.review, hasFills = report.per_hole.some((hole) => hole.filled);
  const isReviewed = review && (hasFills || review.items.length > 0 || (review.decided ?? 0) > 0);
  const pictured = new Set(report.pictures.map(({ hole }) => hole));
  const queue = isReviewed ? reviewQueue(report, review, report.per_hole, decisionsCommand(report), {
    addHint: '\u201cDecide\u201d in the table of holes adds any other fill.',
    pictureOf: (hole) => (pictured.has(hole) ? { href: `#${pictureId(hole)}` } : null) }) : null;
  const holes = holesTable(report, undefined, queue?.decide, queue?.canDecide);
  const parts: HTMLElement[] = [
    el('header', {}, el('h1', {}, 'tilemend report'),
      el('p', { class: 'quiet' }, [report.scene, report.date, report.version && `release ${report.version}`].filter(Boolean).join(' \u00b7 ')),
      el('button', { type: 'button', class: 'print', click: () => window.print() }, 'Print or save as PDF')),
    verdict(report), ...(report.acceptance ? [acceptance(report.acceptance)] : []), ...(report.warnings?.length ? [warningList(report.warnings)] : []), facts(report)];
  if (report.acceptance?.faults.length) parts.push(section('Faults', faults(report.acceptance.faults)));
  parts.push(section('Cells', cellMap(report, holes.showCell)));
  if (queue) parts.push(section('Review', queue.element));
  const others = otherLooks(report);
  if (others.length) parts.push(section('Places to look at', looks(others, report.per_hole)));
  parts.push(section('The largest fills', el('p', { class: 'quiet' }, ...(report.pictures.length > 0 ? HOW_TO_LOOK : [whyNoPictures(report)])),
    ...report.picture_problems.map((text) => el('p', { class: 'warning' }, text)), pictures(report)));
  if (report.water?.length) parts.push(section('Waters', waters(report.water)));
  parts.push(section('Holes', holes.element));
  if (report.levels?.length) parts.push(section('Levels of detail', levels(report.levels)));
  parts.push(options(report));
  return parts;
}

// What is folded is opened for the paper, and closed again after it.
let opened: HTMLDetailsElement[] = [];
addEventListener('beforeprint', () => {
  opened.push(...document.querySelectorAll<HTMLDetailsElement>('details:is(.warnings, .again):not([open])'));
  for (const box of opened) box.open = true;
});
addEventListener('afterprint', () => {
  for (const box of opened) box.open = false;
  opened = [];
});
document.getElementById('page')?.replaceChildren(...build(readReport()));
