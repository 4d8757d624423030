// The review queue: what a reviewer decides on fills in doubt. It is kept in the browser until it is downloaded.
import { copyable } from './command';
import { type Hole, holesOf, type LookAt, type Outline, type Report, type Review, type ReviewItem } from './data';
import { areaText, counted, el, holesText, number, volumeText } from './dom';
import { unzip } from './unzip';

const STEP = 50; // rows that are shown at once
const CHOICES = [['', 'not decided'], ['accept', 'accept'], ['water', 'redo as water'], ['ground', 'redo as ground'],
  ['open', 'leave open']] as const;
type Decision = 'accept' | 'water' | 'ground' | 'open';
const KEYS: Record<string, Decision | ''> = { a: 'accept', w: 'water', g: 'ground', o: 'open', x: '' };

interface Mark { decision: Decision; level: string } // the level as it was typed; of water alone
type Outlines = Record<string, Outline[]>;           // by hole of the item

// What this reads of the feature of an earlier decision.
interface Earlier { properties: { hole: number | null; cluster: number | null; decision: Decision; level_m: number | null } }

// The marks of one report, kept in the browser where it keeps anything. Several tabs may show the report: each writes
// what changed, and hears of what others write.
class Marks {
  private marks = new Map<number, Mark>();
  keeps = true;

  constructor(private readonly name: string) { this.read(); }

  get size(): number { return this.marks.size; }
  get(hole: number): Mark | undefined { return this.marks.get(hole); }
  entries(): [number, Mark][] { return [...this.marks]; }

  set(hole: number, mark: Mark | null): void {
    this.read();
    if (mark) this.marks.set(hole, mark);
    else this.marks.delete(hole);
    this.keep();
  }

  clear(): void {
    this.marks.clear();
    this.keep();
  }

  // Tells `changed` of what other tabs write, while `page` is shown.
  listen(page: HTMLElement, changed: () => void): void {
    const hear = ({ key }: StorageEvent) => {
      if (!page.isConnected) return removeEventListener('storage', hear);
      if (key !== this.name && key !== null) return;
      this.read();
      changed();
    };
    addEventListener('storage', hear);
  }

  private read(): void {
    if (!this.keeps) return; // what is here is all there is
    try {
      this.marks = new Map(JSON.parse(localStorage.getItem(this.name) ?? '[]') as [number, Mark][]);
    } catch {
      this.keeps = false;
    }
  }

  private keep(): void {
    try {
      localStorage.setItem(this.name, JSON.stringify(this.entries()));
    } catch {
      this.keeps = false;
    }
  }
}

const MOST_HEIGHT = 1e5; // metres above or below 0, as --decisions takes it (common/gis/feature_properties.cc)

// A level as it was typed, with a decimal point or comma: a number, null for none, undefined for what is no height.
function levelOf(text: string): number | null | undefined {
  const trimmed = text.trim().replace(/^([-+]?\d*),(\d+)$/, '$1.$2');
  if (trimmed === '') return null;
  return Math.abs(Number(trimmed)) <= MOST_HEIGHT ? Number(trimmed) : undefined;
}

// A feature for each hole: those of one mark may touch, so together they are no valid MultiPolygon. Earlier decisions
// come first: of several on one hole the last one decides. `scene` as kSceneMember in coordinator/report/scene_member.h.
export function decisionsGeoJson(earlier: unknown[], marks: [number, Mark][], outlines: Outlines, crs: unknown, scene: unknown): string {
  const made = marks.flatMap(([item, { decision, level }]) => (outlines[item] ?? []).map(({ hole, cluster, geometry }) => ({
    type: 'Feature',
    properties: { hole, cluster, decision, level_m: decision === 'water' ? levelOf(level) ?? null : null },
    geometry })));
  const features = [...earlier, ...made].map((feature) => JSON.stringify(feature));
  const head = (crs ? `"crs": ${JSON.stringify(crs)},\n` : '') + (scene ? `"tilemend_scene": ${JSON.stringify(scene)},\n` : '');
  return `{"type": "FeatureCollection",\n${head}"features": [\n${features.join(',\n')}\n]}\n`;
}

// Earlier decisions by what they were made on: the holes of a cluster are decided on together.
function groupsOf(earlier: Earlier[]): Map<string, Earlier[]> {
  const groups = new Map<string, Earlier[]>();
  for (const feature of earlier) {
    const { hole, cluster, decision } = feature.properties;
    const key = `${cluster === null ? `hole ${hole}` : `cluster ${cluster}`} ${decision}`;
    groups.set(key, [...groups.get(key) ?? [], feature]);
  }
  return groups;
}

// The earlier decisions, each of which can be undone. `undone` gets the features that the next file is to leave out.
function earlierTable(groups: Map<string, Earlier[]>, undone: Set<Earlier>, changed: () => void): HTMLElement {
  const row = (features: Earlier[]) => {
    const { decision, level_m: level } = features[0]!.properties, holes = features.map((f) => f.properties.hole).join(', ');
    const box = el('input', { type: 'checkbox', 'aria-label': `undo the decision on hole ${holes}`, change: () => {
      for (const feature of features) if (box.checked) undone.add(feature); else undone.delete(feature);
      changed();
    } });
    return el('tr', { class: 'decided' }, el('td', {}, holes), el('td', {}, CHOICES.find(([value]) => value === decision)?.[1] ?? decision),
      el('td', { class: 'number' }, number(level, 3)), el('td', {}, el('label', {}, box, ' undo')));
  };
  const all = [...groups.values()], body = el('tbody', {}, ...all.slice(0, STEP).map(row));
  const more = el('button', { type: 'button', click: () => { body.append(...all.slice(STEP).map(row)); more.hidden = true; } }, 'show all');
  more.hidden = all.length <= STEP;
  return el('div', { class: 'earlier' }, el('h3', {}, 'Decided in earlier rounds'),
    el('p', { class: 'quiet' }, 'The next file contains these decisions. One that is marked \u201cundo\u201d is left out, and the next run makes its fill as it was found.'),
    el('div', { class: 'scroll' }, el('table', {}, el('thead', {}, el('tr', {},
      ...['holes', 'decision', 'level [m]', ''].map((text, i) => el('th', { scope: 'col', class: i === 2 ? 'number' : '' }, text)))), body)), more);
}

async function unpack(packed: string): Promise<unknown> {
  return JSON.parse(new TextDecoder().decode(await unzip(packed)));
}

function save(text: string, name: string): void {
  const url = URL.createObjectURL(new Blob([text], { type: 'application/geo+json' }));
  const link = el('a', { href: url, download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 10000);
}

// The level of a fill that is flat.
const flatLevelOf = (hole: Hole | undefined): number | null => (hole?.filled && typeof hole.level === 'number' ? hole.level : null);

// "419.743 \u00b1 0.823", of a rim that has a level; without a standard deviation if the user gave it.
function rimText({ sigma_m: sigma }: ReviewItem, level: number | null): string {
  return level === null || sigma === undefined ? number(level, 3) : `${number(level, 3)} \u00b1 ${number(sigma, 3)}`;
}

// Not of a river, which falls, nor of ground, whose rim is uneven or too short to tell.
const hasLevelRim = ({ taken_for: verdict }: ReviewItem): boolean => verdict === 'lake' || verdict === 'level ground';

// What the method of a fill says that the hole was taken for, if it was not judged.
function takenForOf({ method }: Hole): string {
  if (method.startsWith('over the ground')) return 'ground';
  return method === 'water' || method === 'level ground' ? method : '\u2013';
}

// The row of a hole that is not in the queue, with all others that are decided on with it: those of its cluster.
function itemOf(hole: Hole, holes: Hole[]): ReviewItem {
  const cluster = hole.cluster ?? -1;
  const members = cluster < 0 ? [hole] : holes.filter((h) => h.filled && h.cluster === cluster);
  const largest = members.reduce((most, h) => ((h.area ?? 0) > (most.area ?? 0) ? h : most), hole);
  const sum = (of: (h: Hole) => number | null) => members.reduce((all, h) => all + (of(h) ?? 0), 0);
  const level = typeof largest.rim_level === 'number' ? largest.rim_level : flatLevelOf(largest) ?? undefined, area = sum((h) => h.area);
  const doubt = members.some((h) => typeof h.doubt === 'number') ? sum((h) => h.doubt) : null;
  return { hole: largest.id, holes: members.map((h) => h.id), cell: largest.cell, area_m2: area, taken_for: largest.taken_for || takenForOf(largest),
    ...(level === undefined ? {} : { level_m: level }), ...(typeof largest.sigma === 'number' ? { sigma_m: largest.sigma } : {}),
    reason: largest.reason, doubt_m: doubt === null || area === 0 ? null : doubt / area, doubt_m3: doubt, crossings: sum((h) => h.crossings) };
}

// The columns of the queue, but for the last one, which has the decision.
interface Column { title: string; isNumber: boolean; class?: string; text: (row: { item: ReviewItem; rank: string; absolute: number | null; why: string }) => string }
const COLUMNS: Column[] = [
  { title: '', isNumber: true, text: ({ rank }) => rank },
  { title: 'hole', isNumber: true, text: ({ item }) => holesText(item) },
  { title: 'cell', isNumber: false, text: ({ item }) => (item.cell ?? []).join(', ') },
  { title: 'area [m\u00b2]', isNumber: true, text: ({ item }) => areaText(item.area_m2) },
  { title: 'taken for', isNumber: false, text: ({ item }) => item.taken_for },
  { title: 'level of the rim \u00b1 sigma [m]', isNumber: true, text: ({ item, absolute }) => rimText(item, absolute) },
  { title: 'doubt [m]', isNumber: true, text: ({ item }) => number(item.doubt_m, 3) },
  { title: 'doubt [m\u00b3]', isNumber: true, text: ({ item }) => volumeText(item.doubt_m3) },
  { title: 'crossings', isNumber: true, text: ({ item }) => (item.crossings ? number(item.crossings) : '') },
  { title: 'because', isNumber: false, class: 'because', text: ({ item, why }) => [item.reason, why].filter(Boolean).join('; ') },
];

class Row {
  readonly element: HTMLTableRowElement;
  private readonly choice: HTMLSelectElement;
  private readonly level: HTMLInputElement;

  constructor(readonly item: ReviewItem, rank: string, private readonly absolute: number | null, cells: HTMLElement[],
    private readonly marks: Marks, changed: () => void) {
    const name = `hole ${holesText(item)}`;
    this.hole = item.hole;
    this.choice = el('select', { 'aria-label': `decision on ${name}`,
      change: () => { this.set(this.choice.value as Decision | ''); changed(); } },
      ...CHOICES.map(([value, text]) => el('option', { value }, text)));
    this.level = el('input', { type: 'text', inputmode: 'decimal', class: 'level', placeholder: 'as its shore',
      title: `${hasLevelRim(item) ? '' : 'The rim is not known to be level. '}A height of the scene\u2019s CRS in metres. Without one the water gets the level of its shore.`,
      'aria-label': `level of ${name} [m]`, input: () => { this.store('water'); changed(); } });
    this.element = el('tr', { tabindex: '0', 'aria-label': [rank, name].filter(Boolean).join(', '), 'data-hole': String(item.hole) },
      ...cells,
      el('td', {}, el('div', { class: 'decide' }, this.choice, this.level)));
    this.show();
  }
  readonly hole: number;

  // True if the level is a number or empty.
  get isGood(): boolean {
    const mark = this.marks.get(this.hole);
    return mark?.decision !== 'water' || levelOf(mark.level) !== undefined;
  }

  set(decision: Decision | ''): void {
    if (decision === 'water' && this.level.value === '' && this.absolute !== null && hasLevelRim(this.item)) this.level.value = this.absolute.toFixed(3);
    this.store(decision);
    if (decision === 'water') this.level.select();
  }

  show(): void {
    const mark = this.marks.get(this.hole);
    this.choice.value = mark?.decision ?? '';
    if (mark?.decision === 'water' && this.level.value !== mark.level) this.level.value = mark.level;
    this.level.hidden = mark?.decision !== 'water';
    this.level.setAttribute('aria-invalid', this.isGood ? 'false' : 'true');
    this.element.classList.toggle('decided', mark !== undefined);
  }

  private store(decision: Decision | ''): void {
    this.marks.set(this.hole, decision ? { decision, level: decision === 'water' ? this.level.value : '' } : null);
    this.show();
  }
}

// Where a picture of a hole is, and what shows it if that is no place of the page.
export interface PictureLink { href: string; show?: () => void }

export interface QueueTexts {
  addHint: string;      // how a fill that is not in the queue gets a row
  commandHint?: string;
  pictureOf: (hole: number) => PictureLink | null;
}

function pictureLink(text: string, { href, show }: PictureLink): HTMLElement {
  const title = 'show its picture';
  return el('a', show ? { href, title, click: (event) => { event.preventDefault(); show(); } } : { href, title }, text);
}

export interface ReviewQueue {
  element: HTMLElement;
  canDecide: (hole: Hole) => boolean; // false: there is no outline for the file
  decide: (hole: Hole) => void; // focuses its row, which a hole that is not in the queue gets if it can be decided on
}

// The marks are those of this scene, date and folder. `holes`: those of the table, which can be decided on as well.
// `command` makes use of the file.
export function reviewQueue(report: Pick<Report, 'scene' | 'date' | 'look_at' | 'out'>, review: Review, holes: Hole[],
  command: string | null, { addHint, commandHint, pictureOf }: QueueTexts): ReviewQueue {
  const marks = new Marks(['tilemend decisions', report.scene ?? '', report.date ?? '', ...(report.out ? [report.out] : [])].join(' '));
  const reasons = new Map((report.look_at ?? []).flatMap((look: LookAt) => holesOf(look).map((hole) => [hole, look.why ?? ''])));
  const holeOf = new Map(holes.map((hole) => [hole.id, hole]));
  const withoutOutline = new Set(review.without_outline);
  const hasCrossings = [...review.items, ...holes].some(({ crossings }) => crossings);
  const columns = COLUMNS.filter(({ title }) => title !== 'crossings' || hasCrossings);
  const rowOf = new Map<number, Row>(); // by each hole of a row
  const makeRow = (item: ReviewItem, rank: string): Row => {
    const level = flatLevelOf(holeOf.get(item.hole)) ?? item.level_m; // as the caption and the table have it
    const absolute = level === undefined || review.z === null ? null : level + review.z;
    const why = holesOf(item).map((hole) => reasons.get(hole)).find(Boolean) ?? '';
    const picture = holesOf(item).map(pictureOf).find(Boolean);
    const cells = columns.map((column) => {
      const text = column.text({ item, rank, absolute, why });
      const hasLabel = column.title !== '' && column.class !== 'because'; // where the table is narrow
      return el('td', { class: column.class ?? (column.isNumber ? 'number' : ''), ...(hasLabel ? { 'data-label': column.title } : {}) }, picture && column.title === 'hole' ? pictureLink(text, picture) : text);
    });
    const row = new Row(item, rank, absolute, cells, marks, () => tell());
    for (const hole of item.holes) rowOf.set(hole, row);
    return row;
  };
  const rows = review.items.map((item, i) => makeRow(item, String(i + 1))), added: Row[] = []; // of fills that are not in the queue
  const allRows = (): Row[] => [...rows, ...added];
  const body = el('tbody', {}), status = el('span', { class: 'quiet', role: 'status' });
  const undone = new Set<Earlier>(), earlierBox = el('div', {});
  let unpacked: Promise<Earlier[]> | null = null;
  const readEarlier = (): Promise<Earlier[]> => (unpacked ??= unpack(review.earlier) as Promise<Earlier[]>);
  let shown = STEP;
  const more = el('button', { type: 'button', click: () => { shown += 10 * STEP; fill(); } }, 'show more');
  const download = el('button', { type: 'button', class: 'download', click: () => void write() }, 'Download decisions');
  const forget = el('button', { type: 'button', click: () => { marks.clear(); allRows().forEach((row) => row.show()); tell(); } },
    'Forget decisions');

  function fill(): void {
    body.replaceChildren(...[...rows.slice(0, shown), ...added].map((row) => row.element));
    more.hidden = rows.length <= shown;
    box.hidden = rows.length + added.length === 0;
  }

  function add(hole: Hole): Row {
    const item = itemOf(hole, holes.filter((h) => !rowOf.has(h.id)));
    const row = makeRow(item, '');
    added.push(row);
    fill();
    return row;
  }

  // Rows of holes that were marked before, or in another tab.
  function addMarked(): void {
    for (const [id] of marks.entries()) {
      const hole = rowOf.has(id) ? undefined : holes.find((h) => h.id === id);
      if (hole) add(hole);
    }
  }

  function tell(): void {
    const bad = allRows().find((row) => !row.isGood);
    const othersDecided = added.filter((row) => marks.get(row.hole)).length, decided = rows.filter((row) => marks.get(row.hole)).length;
    const all = review.count > review.items.length ? ` (of ${number(review.count)} in doubt the ${number(review.items.length)} first)` : '';
    const ofQueue = rows.length > 0 ? `${number(decided)} of ${counted(rows.length, 'fill')}${all} decided` : '';
    const ofOthers = othersDecided > 0 ? `${counted(othersDecided, 'other fill')} decided` : '';
    status.textContent = bad ? `The level of hole ${bad.hole} is no height: give metres from -100000 to 100000.` : [ofQueue, ofOthers, marks.keeps ? '' : 'this browser does not keep decisions'].filter(Boolean).join('; ');
    if (undone.size > 0 && !bad) status.textContent += `${status.textContent ? '; ' : ''}${counted(undone.size, 'earlier decision')} undone`;
    download.disabled = (marks.size === 0 && undone.size === 0) || bad !== undefined;
    forget.disabled = marks.size === 0;
  }

  async function write(): Promise<void> {
    const outlines = await unpack(review.outlines) as Outlines, earlier = (await readEarlier()).filter((feature) => !undone.has(feature));
    const others = added.length > 0 ? await unpack(review.others) as Record<string, Outline> : {};
    for (const { item } of added) {
      const known = item.holes.flatMap((hole) => others[hole] ?? []);
      if (known.length > 0) outlines[item.hole] = known;
    }
    save(decisionsGeoJson(earlier, marks.entries(), outlines, review.crs, review.scene), 'decisions.geojson');
    const without = marks.entries().filter(([hole]) => !outlines[hole]).map(([hole]) => hole);
    if (without.length > 0) status.textContent = `Not in the file, as they have no outline: holes ${without.join(', ')}`;
  }

  // Keys on a row: arrows go up and down, letters decide.
  body.addEventListener('keydown', (event) => {
    const target = event.target as HTMLElement, element = target.closest('tr');
    const row = allRows().find((r) => r.element === element);
    if (!row || !element) return;
    if (target instanceof HTMLAnchorElement && event.key === 'Enter') return; // follows it
    if (target !== element) {
      if (event.key === 'Enter' || event.key === 'Escape') element.focus();
      return;
    }
    const step = event.key === 'ArrowDown' ? element.nextElementSibling : event.key === 'ArrowUp' ? element.previousElementSibling : null;
    if (step) (step as HTMLElement).focus();
    const decision = event.ctrlKey || event.metaKey || event.altKey ? undefined : KEYS[event.key.toLowerCase()];
    if (decision !== undefined) {
      row.set(decision);
      tell();
    }
    if (step || decision !== undefined) event.preventDefault();
  });
  const heading = ({ title, isNumber, class: kind }: Omit<Column, 'text'>) => el('th', { scope: 'col', class: kind ?? (isNumber ? 'number' : '') }, title);
  const box = el('div', { class: 'scroll' }, el('table', { class: 'queue' }, el('thead', {}, el('tr', {},
    ...columns.map(heading), heading({ title: 'decision', isNumber: false }))), body));
  fill();
  addMarked();
  tell();
  const queue = el('div', { class: 'review' },
    el('p', { class: 'quiet' }, (rows.length === 0 ? 'No fill waits for a decision. ' : 'Fills by their doubt: the error of height that is to be expected, times the area. '),
      ...(rows.length === 0 ? [] : [el('span', { class: 'hint' }, 'In a row: \u2191 \u2193 to move, A accept, W water, G ground, O leave open, X not decided. '), 'Levels are heights of the scene\u2019s CRS. ' +
      '\u201cRedo as water\u201d takes the level that is typed, or that of the shore if none is; that of a level rim is there already. ']),
      el('span', { class: 'hint' }, `${addHint} `), 'The file has the decisions of earlier rounds as well. This makes the fills anew that are to be redone' +
      (command ? ':' : ': tilemend run with --decisions FILE and the same scene, folder and options.')),
    ...(command ? [copyable(command)] : []), ...(command && commandHint ? [el('p', { class: 'quiet' }, commandHint)] : []),
    el('div', { class: 'filters' }, download, forget, status),
    box, more, earlierBox);
  if (review.decided) void readEarlier().then((earlier) => { earlierBox.replaceChildren(earlierTable(groupsOf(earlier), undone, tell)); });
  marks.listen(queue, () => { addMarked(); allRows().forEach((row) => row.show()); tell(); });
  const canDecide = (hole: Hole): boolean => rowOf.has(hole.id) || !withoutOutline.has(hole.id);
  const decide = (hole: Hole) => {
    if (!canDecide(hole)) {
      status.textContent = `Hole ${hole.id} has no outline here, so it cannot be decided on in this page.`;
      status.scrollIntoView({ block: 'center' });
      return;
    }
    const row = rowOf.get(hole.id) ?? add(hole);
    if (!row.element.isConnected) { // below those that are shown
      shown = rows.length;
      fill();
    }
    row.element.scrollIntoView({ block: 'center' });
    row.element.focus();
  };
  return { element: queue, canDecide, decide };
}
