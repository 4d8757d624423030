// The table of holes: sorted by any column, filtered by text, outcome and cell.
import type { Hole, Level, Report } from './data';
import { areaText, counted, el, number, volumeText } from './dom';

const STEP = 100; // rows that are shown at once

export function levelText(level: Level): string {
  return Array.isArray(level) ? `${number(level[0], 3)} to ${number(level[1], 3)}` : number(level, 3);
}

interface Column {
  title: string;
  label?: string; // before the value where the table is narrow
  isNumber: boolean;
  isOptional?: boolean; // not shown where no hole has a text
  text: (hole: Hole) => string;
  key: (hole: Hole) => number | string;
}

export const isOfMesh = ({ centre }: Hole): boolean => centre?.length === 3; // a place of a scene has two coordinates
export const areaOf = (hole: Hole): string => areaText(hole.area, isOfMesh(hole));
export const squareMetres = (hole: Hole): string => (hole.area === null ? 'area unknown' : `${areaOf(hole)} m\u00b2`);

const outcomeOf = (h: Hole): string => (h.planned ? 'planned' : h.filled ? h.method || 'filled' : 'left open');
const firstLevel = (level: Level) => (Array.isArray(level) ? level[0] : level) ?? -Infinity;
const COLUMNS: Column[] = [
  { title: 'hole', label: 'hole', isNumber: true, text: (h) => String(h.id), key: (h) => h.id },
  { title: 'cell', label: 'cell', isNumber: false, text: (h) => (h.cell ?? []).join(', '),
    key: (h) => (h.cell ? h.cell[1] * 1e6 + h.cell[0] : 0) },
  { title: 'x, y [m]', label: 'at', isNumber: false, text: (h) => (h.centre ?? []).slice(0, 2).map((c) => c.toFixed(1)).join(', '),
    key: (h) => h.centre?.[0] ?? 0 },
  { title: 'kind', isNumber: false, text: (h) => h.kind, key: (h) => h.kind },
  { title: 'area [m\u00b2]', label: 'area', isNumber: true, text: areaOf, key: (h) => h.area ?? -Infinity },
  { title: 'outcome', isNumber: false, text: outcomeOf, key: (h) => (h.filled || h.planned ? outcomeOf(h) : '') },
  { title: 'level [m]', label: 'level', isNumber: true, text: (h) => levelText(h.level), key: (h) => firstLevel(h.level) },
  { title: 'sigma [m]', label: 'sigma', isNumber: true, text: (h) => number(h.sigma, 3), key: (h) => h.sigma ?? -Infinity },
  { title: 'doubt [m\u00b3]', label: 'doubt', isNumber: true, text: (h) => volumeText(h.doubt), key: (h) => h.doubt ?? -Infinity },
  { title: 'crossings', label: 'crossings', isNumber: true, isOptional: true, text: (h) => number(h.crossings), key: (h) => h.crossings ?? 0 },
  { title: 'reason', isNumber: false, text: (h) => h.reason, key: (h) => h.reason },
];

const LONG = 80, SHORT = 40; // letters of a reason

// A long reason in full where it is first, then only its beginning, which opens.
function reasonCell(reason: string, seen: Set<string>): HTMLElement {
  if (reason.length <= LONG || !seen.has(reason)) {
    seen.add(reason);
    return el('td', {}, reason);
  }
  const beginning = `${reason.slice(0, SHORT).replace(/\s+\S*$/, '')}\u2026`;
  return el('td', {}, el('details', { class: 'again', click: (event) => event.stopPropagation() },
    el('summary', { title: reason }, beginning), reason));
}

export type HoleRows = Pick<Report, 'per_hole' | 'hole_count'>;

export interface HolesTable {
  element: HTMLElement;
  showCell: (cell: readonly [number, number, ...number[]]) => void;
  update: (rows: HoleRows) => void; // keeps what is filtered and sorted
}

// A number that an entry must reach to be shown.
function least(name: string): HTMLInputElement {
  return el('input', { type: 'number', min: '0', step: 'any', placeholder: name, 'aria-label': name, class: 'least' });
}

// `choose` hears of a hole whose row was chosen, `decide` of one with a fill whose button was: those that `canDecide` have
// one.
export function holesTable(rows: HoleRows, choose?: (hole: Hole) => void, decide?: (hole: Hole) => void,
  canDecide: (hole: Hole) => boolean = () => true): HolesTable {
  let report = rows;
  let sorted: { column: number; down: boolean } | null = null;
  let shown = STEP;
  let cell: readonly number[] | null = null; // whose holes alone are shown
  const search = el('input', { type: 'search', placeholder: 'filter, e.g. water', 'aria-label': 'filter' });
  const ofCell = el('button', { type: 'button', hidden: '', title: 'show the holes of all cells', click: () => setCell(null) });
  const outcome = el('select', { 'aria-label': 'outcome' });
  for (const [value, text] of [['', 'all outcomes'], ['left', 'left open'], ['filled', 'filled'], ['planned', 'planned']] as const) {
    outcome.append(el('option', { value }, text));
  }
  const kind = el('select', { 'aria-label': 'kind' });
  let toldKinds = '';
  const tellKinds = () => {
    const before = kind.value, names = [...new Set(report.per_hole.map((h) => h.kind))].sort();
    if (names.join() === toldKinds) return; // the list may be open
    toldKinds = names.join();
    kind.replaceChildren(el('option', { value: '' }, 'all kinds'), ...names.map((name) => el('option', { value: name }, name)));
    kind.value = names.includes(before) ? before : '';
  };
  const area = least('least area [m\u00b2]'), sigma = least('least sigma [m]'), crossings = least('least crossings');
  const count = el('span', { class: 'quiet', role: 'status' });
  const head = el('tr'), body = el('tbody');
  const more = el('button', { type: 'button', click: () => { shown += 10 * STEP; update(); } }, 'show more');

  const decideButton = (hole: Hole): (Node | string)[] => (!decide || !hole.filled || hole.planned || !canDecide(hole) ? [] : [' ', el('button', {
    type: 'button', class: 'decidehole', 'aria-label': `decide on hole ${hole.id}`,
    click: (event) => { event.stopPropagation(); decide(hole); } }, 'decide')]);
  const rest = el('p', { class: 'quiet onlyprint' });

  const matching = (): Hole[] => {
    const words = search.value.trim().toLowerCase();
    const holes = report.per_hole.filter((hole) =>
      (cell === null || (hole.cell?.[0] === cell[0] && hole.cell[1] === cell[1])) &&
      (outcome.value === '' || outcome.value === (hole.planned ? 'planned' : hole.filled ? 'filled' : 'left')) &&
      (kind.value === '' || kind.value === hole.kind) &&
      (area.value === '' || (hole.area ?? Infinity) >= Number(area.value)) &&
      (sigma.value === '' || (hole.sigma ?? -Infinity) >= Number(sigma.value)) &&
      (crossings.value === '' || (hole.crossings ?? 0) >= Number(crossings.value)) &&
      (words === '' || COLUMNS.some((column) => column.text(hole).toLowerCase().includes(words))));
    if (!sorted) return holes;
    const { key } = COLUMNS[sorted.column]!, sign = sorted.down ? -1 : 1;
    return holes.sort((a, b) => {
      const [x, y] = [key(a), key(b)];
      return sign * (typeof x === 'number' && typeof y === 'number' ? x - y : String(x).localeCompare(String(y)));
    });
  };

  function update(): void {
    const holes = matching();
    const listed = report.per_hole.length;
    const of = listed < report.hole_count ? ` (${number(listed)} of ${number(report.hole_count)} are listed here)` : '';
    count.textContent = counted(holes.length, 'hole') + of;
    const focused = body.contains(document.activeElement) ? (document.activeElement as HTMLElement).dataset['hole'] : undefined;
    const listedHere = holes.slice(0, shown), seen = new Set<string>();
    const blank = COLUMNS.map((c) => (listedHere.some((hole) => c.text(hole) !== '') ? '' : 'blank')); // not printed
    const absent = COLUMNS.map((c) => (c.isOptional && report.per_hole.every((hole) => c.text(hole) === '') ? 'absent' : ''));
    const kind = (c: Column, i: number) => [c.isNumber ? 'number' : '', blank[i], absent[i]].filter(Boolean).join(' ');
    crossings.hidden = absent[COLUMNS.findIndex((c) => c.title === 'crossings')] !== '';
    body.replaceChildren(...listedHere.map((hole) =>
      el('tr', { 'data-hole': String(hole.id), class: hole.counts && !hole.planned ? 'open' : '', ...(choose ? { tabindex: '0', click: () => choose(hole),
        keydown: (event: Event) => { if ((event as KeyboardEvent).key === 'Enter') choose(hole); } } : {}) },
        ...COLUMNS.map((c, i) => (c.title === 'reason' ? reasonCell(hole.reason, seen)
          : el('td', { class: kind(c, i), ...(c.label ? { 'data-label': c.label } : {}) }, c.text(hole), ...(c.title === 'outcome' ? decideButton(hole) : [])))))));
    if (focused) body.querySelector<HTMLElement>(`tr[data-hole="${focused}"]`)?.focus({ preventScroll: true });
    more.hidden = holes.length <= shown;
    head.querySelectorAll('th').forEach((th, i) => {
      th.className = kind(COLUMNS[i]!, i);
      th.setAttribute('aria-sort', sorted?.column !== i ? 'none' : sorted.down ? 'descending' : 'ascending');
    });
    rest.textContent = more.hidden ? '' : `and ${number(holes.length - shown)} more holes, which are not printed; holes.csv has all`;
  }

  COLUMNS.forEach((column, i) => {
    const sort = () => {
      sorted = { column: i, down: sorted?.column === i ? !sorted.down : column.isNumber };
      update();
    };
    head.append(el('th', { 'data-title': column.title }, el('button', { type: 'button', click: sort }, column.title)));
  });
  for (const input of [search, outcome, kind, area, sigma, crossings]) {
    input.addEventListener('input', () => { shown = STEP; update(); });
  }
  tellKinds();
  update();
  const element = el('div', {},
    el('div', { class: 'filters' }, search, ofCell, outcome, kind, area, sigma, crossings, count),
    el('div', { class: 'scroll' }, el('table', { class: 'holes' }, el('thead', {}, head), body)), rest, more);
  function setCell(next: readonly number[] | null): void {
    cell = next;
    ofCell.hidden = next === null;
    ofCell.textContent = next === null ? '' : `cell ${next[0]}, ${next[1]} \u00d7`;
    shown = STEP;
    update();
  }
  const showCell = (next: readonly [number, number, ...number[]]) => {
    setCell(next);
    if (search.value && matching().length === 0) { // what was asked for before is not in this cell
      search.value = '';
      update();
    }
    element.scrollIntoView({ behavior: 'smooth' });
  };
  return { element, showCell, update: (next) => { report = next; tellKinds(); update(); } };
}
