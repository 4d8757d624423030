// The grid of cells, coloured by what became of their holes.
import type { Cell, Report } from './data';
import { el, svg } from './dom';

const MOST_IN_SVG = 10000;

type State = 'left' | 'filled' | 'whole' | 'empty';
const NAMES: [State, string][] = [
  ['left', 'holes left open'], ['filled', 'all holes filled'], ['whole', 'no hole'], ['empty', 'no tile']];

function stateOf([, , filled, left, tile]: Cell): State {
  if (left > 0) return 'left';
  if (filled > 0) return 'filled';
  return tile ? 'whole' : 'empty';
}

function textOf(cell: Cell): string {
  const [column, row, filled, left] = cell;
  return `cell ${column}, ${row}: ${filled} filled, ${left} left open`;
}

interface Frame { column: number; row: number; columns: number; rows: number }

function frameOf(cells: Cell[]): Frame {
  let [c0, c1, r0, r1] = [Infinity, -Infinity, Infinity, -Infinity];
  for (const [c, r] of cells) {
    c0 = Math.min(c0, c); c1 = Math.max(c1, c); r0 = Math.min(r0, r); r1 = Math.max(r1, r);
  }
  return { column: c0, row: r0, columns: c1 - c0 + 1, rows: r1 - r0 + 1 };
}

// Width and height of a cell in pixels.
function sizeOf(report: Report, frame: Frame): [number, number] {
  const [w, h] = report.grid?.cell_size ?? [1, 1];
  const scale = Math.min(1000 / (frame.columns * w), 480 / (frame.rows * h), 56 / Math.max(w, h));
  return [scale * w, scale * h];
}

function drawSvg(cells: Cell[], frame: Frame, [w, h]: [number, number], choose: (cell: Cell) => void): Element {
  const root = svg('svg', {
    class: 'map', role: 'img', 'aria-label': 'map of the cells',
    width: frame.columns * w, height: frame.rows * h, viewBox: `0 0 ${frame.columns * w} ${frame.rows * h}` });
  for (const cell of cells) {
    const title = svg('title', {});
    title.textContent = textOf(cell);
    const gap = Math.min(1, w / 8);
    const square = svg('rect', {
      class: `cell ${stateOf(cell)}`, x: (cell[0] - frame.column) * w + gap / 2,
      y: (frame.rows - 1 - (cell[1] - frame.row)) * h + gap / 2, width: w - gap, height: h - gap }, title);
    square.addEventListener('click', () => choose(cell));
    root.append(square);
  }
  return root;
}

function drawCanvas(cells: Cell[], frame: Frame, [w, h]: [number, number], choose: (cell: Cell) => void): Element {
  const canvas = el('canvas', { class: 'map', role: 'img', 'aria-label': 'map of the cells' });
  canvas.width = Math.ceil(frame.columns * w);
  canvas.height = Math.ceil(frame.rows * h);
  const paint = () => {
    const style = getComputedStyle(canvas), pen = canvas.getContext('2d');
    if (!pen) return;
    pen.clearRect(0, 0, canvas.width, canvas.height);
    for (const cell of cells) {
      pen.fillStyle = style.getPropertyValue(`--${stateOf(cell)}`);
      pen.fillRect((cell[0] - frame.column) * w, (frame.rows - 1 - (cell[1] - frame.row)) * h, w, h);
    }
  };
  const at = new Map(cells.map((cell) => [`${cell[0]},${cell[1]}`, cell]));
  const find = (event: MouseEvent) => {
    const box = canvas.getBoundingClientRect();
    const column = frame.column + Math.floor((event.clientX - box.left) / box.width * frame.columns);
    const row = frame.row + frame.rows - 1 - Math.floor((event.clientY - box.top) / box.height * frame.rows);
    return at.get(`${column},${row}`);
  };
  canvas.addEventListener('mousemove', (event) => {
    const cell = find(event);
    canvas.title = cell ? textOf(cell) : '';
  });
  canvas.addEventListener('click', (event) => {
    const cell = find(event);
    if (cell) choose(cell);
  });
  requestAnimationFrame(paint);
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', paint);
  return canvas;
}

// `choose` hears of a cell that was clicked.
export function cellMap(report: Report, choose: (cell: Cell) => void): HTMLElement {
  const cells = report.cells;
  if (cells.length === 0) return el('p', {}, 'The report names no cell.');
  const frame = frameOf(cells), size = sizeOf(report, frame);
  const draw = cells.length <= MOST_IN_SVG ? drawSvg : drawCanvas;
  const legend = el('ul', { class: 'legend' });
  const there = new Set(cells.map(stateOf));
  for (const [state, name] of NAMES) {
    if (there.has(state)) legend.append(el('li', {}, el('span', { class: `key ${state}` }), name));
  }
  return el('div', { class: 'mapbox' }, el('div', { class: 'scroll' }, draw(cells, frame, size, choose)), legend);
}
