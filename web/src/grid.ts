// A grid of squares, one for each cell: SVG while there are few, a canvas beyond. The states can change.
import { el, svg } from './dom';

const MOST_IN_SVG = 10000;

export interface Square { column: number; row: number }

export interface GridLook<T extends Square> {
  stateOf: (cell: T) => string;    // a class of `.cell`, and a colour `--STATE`
  textOf: (cell: T) => string;
  choose: (cell: T) => void;
  cellSize: [number, number];      // metres
}

export interface Grid<T extends Square> {
  element: Element;
  update: (cells: T[]) => void;    // the same cells, in the same order
  select: (cell: T | null) => void;
}

interface Frame { column: number; row: number; columns: number; rows: number }

function frameOf(cells: Square[]): Frame {
  let [c0, c1, r0, r1] = [Infinity, -Infinity, Infinity, -Infinity];
  for (const { column: c, row: r } of cells) {
    c0 = Math.min(c0, c); c1 = Math.max(c1, c); r0 = Math.min(r0, r); r1 = Math.max(r1, r);
  }
  return { column: c0, row: r0, columns: c1 - c0 + 1, rows: r1 - r0 + 1 };
}

// Width and height of a cell in pixels.
function sizeOf([w, h]: [number, number], frame: Frame): [number, number] {
  const scale = Math.min(1000 / (frame.columns * w), 480 / (frame.rows * h), 56 / Math.max(w, h));
  return [scale * w, scale * h];
}

const nameOf = (cells: Square[]): string => `map of ${cells.length} cells; the arrow keys move, Enter chooses`;

// The arrow keys move a mark over the cells, Enter chooses.
function addKeys<T extends Square>(element: HTMLElement | SVGElement, find: (column: number, row: number) => T | undefined,
  first: () => T | undefined, move: (cell: T) => void, choose: (cell: T) => void): void {
  const steps: Record<string, [number, number]> = {
    ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
  let at: T | undefined;
  element.addEventListener('keydown', (event) => {
    const { key } = event as KeyboardEvent, step = steps[key];
    if (key === 'Enter' && at) choose(at);
    if (!step) return;
    event.preventDefault();
    at = at ? find(at.column + step[0], at.row + step[1]) ?? at : first();
    if (at) move(at);
  });
}

function svgGrid<T extends Square>(cells: T[], frame: Frame, [w, h]: [number, number], look: GridLook<T>): Grid<T> {
  const root = svg('svg', {
    class: 'map', role: 'application', 'aria-label': nameOf(cells), tabindex: 0,
    width: frame.columns * w, height: frame.rows * h, viewBox: `0 0 ${frame.columns * w} ${frame.rows * h}` });
  const gap = Math.min(1, w / 8), squares: SVGElement[] = [], titles: SVGElement[] = [];
  const index = new Map<string, number>();
  cells.forEach((cell, k) => {
    index.set(`${cell.column},${cell.row}`, k);
    const title = svg('title', {});
    const square = svg('rect', {
      x: (cell.column - frame.column) * w + gap / 2, y: (frame.rows - 1 - (cell.row - frame.row)) * h + gap / 2,
      width: w - gap, height: h - gap }, title);
    square.addEventListener('click', () => look.choose(shown[k]!));
    squares.push(square);
    titles.push(title);
  });
  root.append(...squares);
  let shown = cells, chosen = -1;
  const states: string[] = [];
  const paint = (k: number) => {
    const text = look.textOf(shown[k]!), state = look.stateOf(shown[k]!) + (k === chosen ? ' chosen' : '');
    if (titles[k]!.textContent !== text) titles[k]!.textContent = text;
    if (states[k] === state) return;
    states[k] = state;
    squares[k]!.setAttribute('class', `cell ${state}`);
  };
  const update = (next: T[]) => {
    shown = next;
    for (let k = 0; k < next.length; ++k) paint(k);
  };
  const select = (cell: T | null) => {
    const before = chosen;
    chosen = cell ? index.get(`${cell.column},${cell.row}`) ?? -1 : -1;
    if (before >= 0) paint(before);
    if (chosen >= 0) {
      paint(chosen);
      root.setAttribute('aria-label', look.textOf(shown[chosen]!));
    }
  };
  addKeys<T>(root, (c, r) => shown[index.get(`${c},${r}`) ?? -1], () => shown[0], select, look.choose);
  update(cells);
  return { element: root, update, select };
}

function canvasGrid<T extends Square>(cells: T[], frame: Frame, [w, h]: [number, number], look: GridLook<T>): Grid<T> {
  const canvas = el('canvas', { class: 'map', role: 'application', 'aria-label': nameOf(cells), tabindex: '0' });
  canvas.width = Math.ceil(frame.columns * w);
  canvas.height = Math.ceil(frame.rows * h);
  let shown = cells, chosen: T | null = null, asked = false;
  const index = new Map(cells.map((cell, k) => [`${cell.column},${cell.row}`, k]));
  const paint = () => {
    asked = false;
    const style = getComputedStyle(canvas), pen = canvas.getContext('2d');
    if (!pen) return;
    const places = new Map<string, T[]>(); // by state: to set a colour takes longer than to fill a square
    for (const cell of shown) {
      const state = look.stateOf(cell).split(' ')[0]!, list = places.get(state);
      if (list) list.push(cell);
      else places.set(state, [cell]);
    }
    const x = (cell: T) => (cell.column - frame.column) * w, y = (cell: T) => (frame.rows - 1 - (cell.row - frame.row)) * h;
    pen.clearRect(0, 0, canvas.width, canvas.height);
    for (const [state, list] of places) {
      pen.fillStyle = style.getPropertyValue(`--${state}`);
      for (const cell of list) pen.fillRect(x(cell), y(cell), w, h);
    }
    if (!chosen) return;
    pen.strokeStyle = style.getPropertyValue('--ink');
    pen.lineWidth = 2;
    pen.strokeRect(x(chosen) - 3, y(chosen) - 3, w + 6, h + 6);
  };
  const ask = () => {
    if (!asked) requestAnimationFrame(paint);
    asked = true;
  };
  const find = (event: MouseEvent): T | undefined => {
    const box = canvas.getBoundingClientRect();
    const column = frame.column + Math.floor((event.clientX - box.left) / box.width * frame.columns);
    const row = frame.row + frame.rows - 1 - Math.floor((event.clientY - box.top) / box.height * frame.rows);
    return shown[index.get(`${column},${row}`) ?? -1];
  };
  canvas.addEventListener('mousemove', (event) => {
    const cell = find(event);
    canvas.title = cell ? look.textOf(cell) : '';
  });
  canvas.addEventListener('click', (event) => {
    const cell = find(event);
    if (cell) look.choose(cell);
  });
  const select = (cell: T | null) => {
    chosen = cell;
    if (cell) canvas.setAttribute('aria-label', look.textOf(cell));
    ask();
  };
  addKeys<T>(canvas, (c, r) => shown[index.get(`${c},${r}`) ?? -1], () => shown[0], select, look.choose);
  ask();
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', ask);
  return { element: canvas, update: (next) => { shown = next; ask(); }, select };
}

export function makeGrid<T extends Square>(cells: T[], look: GridLook<T>): Grid<T> {
  const frame = frameOf(cells), size = sizeOf(look.cellSize, frame);
  return (cells.length <= MOST_IN_SVG ? svgGrid : canvasGrid)(cells, frame, size, look);
}

// What the colours mean, of those states that are there.
export function legendOf(names: [string, string][], there: Set<string>): HTMLElement {
  return el('ul', { class: 'legend' }, ...names.filter(([state]) => there.has(state)).map(([state, name]) =>
    el('li', {}, el('span', { class: `key ${state}` }), name)));
}
