// A grid of squares, one for each cell: SVG while there are few, beyond a canvas that zooms. The states can change.
import { canvasGrid } from './canvas_grid';
import { el, svg } from './dom';

const MOST_IN_SVG = 10000;
const MOST_SQUARES = 4e6; // as the coordinator has it
const LABEL = 11;         // pixels: the height of a label's letters

export interface Frame { column: number; row: number; columns: number; rows: number }

// The squares of the frame by their number: row after row from the south-west.
export interface Squares {
  frame: Frame;
  stateOf: (k: number) => string;  // classes of `.cell`, the first with a colour `--STATE`; '': no cell is there
  textOf: (k: number) => string;
  held?: Iterable<number>;         // those to be marked on a canvas
}

export interface GridLook {
  choose: (k: number) => void;
  cellSize: [number, number];      // metres
}

export interface Grid {
  element: HTMLElement;
  update: (squares: Squares) => void; // of the same frame
  select: (k: number) => void;        // -1: none
  dispose: () => void;                // once it is not shown any more
}

export const indexIn = (frame: Frame, column: number, row: number): number =>
  column < frame.column || row < frame.row || column >= frame.column + frame.columns || row >= frame.row + frame.rows ? -1
    : (row - frame.row) * frame.columns + column - frame.column;

export function frameOf(cells: { column: number; row: number }[]): Frame {
  let [c0, c1, r0, r1] = [Infinity, -Infinity, Infinity, -Infinity];
  for (const { column: c, row: r } of cells) {
    c0 = Math.min(c0, c); c1 = Math.max(c1, c); r0 = Math.min(r0, r); r1 = Math.max(r1, r);
  }
  return { column: c0, row: r0, columns: c1 - c0 + 1, rows: r1 - r0 + 1 };
}

// The arrow keys move a mark over the cells and over gaps between them, Enter chooses. `marked`: where it is, -1 at first.
export function addKeys(element: Element, squares: () => Squares, marked: () => number, move: (k: number) => void, choose: (k: number) => void): void {
  element.addEventListener('keydown', (event) => {
    const { key } = event as KeyboardEvent, { frame, stateOf } = squares(), at = marked();
    if (key === 'Enter' && at >= 0) choose(at);
    const steps: Record<string, number> = { ArrowLeft: -1, ArrowRight: 1, ArrowUp: frame.columns, ArrowDown: -frame.columns };
    const step = steps[key];
    if (step === undefined) return;
    event.preventDefault();
    const all = frame.columns * frame.rows;
    const isInLine = (k: number) => k >= 0 && k < all && (Math.abs(step) !== 1 || Math.floor(k / frame.columns) === Math.floor(at / frame.columns));
    const [first, by] = at < 0 ? [0, 1] : [at + step, step];
    const isThere = (k: number) => (at < 0 ? k < all : isInLine(k));
    let next = first;
    while (isThere(next) && !stateOf(next)) next += by;
    if (isThere(next)) move(next);
  });
}

function svgGrid(first: Squares, numbers: number[], [w, h]: [number, number], look: GridLook): Grid {
  const { frame } = first, width = frame.columns * w, height = frame.rows * h;
  const root = svg('svg', { class: 'map', role: 'application', tabindex: 0, width, height, viewBox: `0 0 ${width} ${height}`,
    'aria-label': `map of ${numbers.length} cells; the arrow keys move, Enter chooses` });
  const gap = Math.min(1, w / 8), places = new Map(numbers.map((k, i) => [k, i]));
  const titles = numbers.map(() => svg('title', {}));
  const rects = numbers.map((k, i) => {
    const rect = svg('rect', {
      x: k % frame.columns * w + gap / 2, y: (frame.rows - 1 - Math.floor(k / frame.columns)) * h + gap / 2,
      width: w - gap, height: h - gap }, titles[i]!);
    rect.addEventListener('click', () => look.choose(k));
    return rect;
  });
  root.append(...rects);
  // Column and row on cells that have room for them.
  const labels = numbers.map((k) => `${frame.column + k % frame.columns},${frame.row + Math.floor(k / frame.columns)}`);
  const longest = Math.max(...labels.map((text) => text.length));
  if (h >= LABEL + 4 && w >= longest * 0.62 * LABEL + 4) {
    root.append(...numbers.map((k, i) => {
      const label = svg('text', { class: 'celllabel', 'aria-hidden': 'true', 'font-size': LABEL, 'text-anchor': 'middle', 'dominant-baseline': 'central',
        x: (k % frame.columns + 0.5) * w, y: (frame.rows - 0.5 - Math.floor(k / frame.columns)) * h });
      label.textContent = labels[i]!;
      return label;
    }));
  }
  let shown = first, chosen = -1;
  const states: string[] = [];
  const paint = (i: number) => {
    const k = numbers[i]!, text = shown.textOf(k), state = shown.stateOf(k) + (k === chosen ? ' chosen' : '');
    if (titles[i]!.textContent !== text) titles[i]!.textContent = text;
    if (states[i] === state) return;
    states[i] = state;
    rects[i]!.setAttribute('class', `cell ${state}`);
  };
  const update = (next: Squares) => {
    shown = next;
    numbers.forEach((_, i) => paint(i));
  };
  const select = (k: number) => {
    const before = places.get(chosen), now = places.get(k);
    chosen = k;
    if (before !== undefined) paint(before);
    if (now === undefined) return;
    paint(now);
    root.setAttribute('aria-label', shown.textOf(k));
  };
  addKeys(root, () => shown, () => chosen, select, look.choose);
  update(first);
  return { element: el('div', { class: 'scroll' }, root), update, select, dispose: () => undefined };
}

// In place of a grid that cannot be drawn.
export function noGrid(why: string): Grid {
  return { element: el('p', {}, why), update: () => undefined, select: () => undefined, dispose: () => undefined };
}

export function makeGrid(squares: Squares, look: GridLook): Grid {
  const { frame } = squares, [w, h] = look.cellSize;
  if (frame.columns * frame.rows > MOST_SQUARES) return noGrid(`A map of ${frame.columns} by ${frame.rows} cells is too large to be drawn.`);
  const numbers: number[] = [];
  for (let k = 0; k < frame.columns * frame.rows && numbers.length <= MOST_IN_SVG; ++k) if (squares.stateOf(k)) numbers.push(k);
  const scale = Math.min(1000 / (frame.columns * w), 480 / (frame.rows * h), 56 / Math.max(w, h));
  return numbers.length <= MOST_IN_SVG ? svgGrid(squares, numbers, [scale * w, scale * h], look) : canvasGrid(squares, look);
}

// What the colours mean, of those states that are there.
export function legendOf(names: [string, string][], there: Set<string>): HTMLElement {
  return el('ul', { class: 'legend' }, ...names.filter(([state]) => there.has(state)).map(([state, name]) =>
    el('li', {}, el('span', { class: `key ${state}` }), name)));
}
