// A map of very many cells: one pixel a cell in a picture, of which a canvas shows a part, larger or smaller.
import { el } from './dom';
import { addKeys, type Grid, type GridLook, indexIn, noGrid, type Squares } from './grid';

const WIDTH = 1000, HEIGHT = 480; // pixels of the canvas at most
const LARGEST = 48;               // pixels of a cell
const MOST_ALONG = 32767;         // pixels along a side that every browser can draw
const OUTLINED = 6;               // pixels from which on a cell has a gap around it

// One pixel a cell, the first row at the bottom.
class Picture {
  readonly canvas = el('canvas');
  private readonly data: ImageData;
  private readonly colours = new Map<string, number>();

  constructor(columns: number, rows: number) {
    this.canvas.width = columns;
    this.canvas.height = rows;
    this.data = new ImageData(columns, rows);
  }

  // The colours of the page may have changed since.
  forgetColours(): void { this.colours.clear(); }

  paint({ frame, stateOf }: Squares, style: CSSStyleDeclaration): void {
    const pixels = new Uint32Array(this.data.data.buffer);
    for (let row = 0, k = 0; row < frame.rows; ++row) {
      let at = (frame.rows - 1 - row) * frame.columns;
      for (let column = 0; column < frame.columns; ++column, ++k, ++at) {
        const state = stateOf(k);
        pixels[at] = state ? this.colours.get(state) ?? this.colourOf(state, style) : 0;
      }
    }
    this.canvas.getContext('2d')?.putImageData(this.data, 0, 0);
  }

  private colourOf(state: string, style: CSSStyleDeclaration): number {
    const pen = el('canvas').getContext('2d')!;
    pen.fillStyle = style.getPropertyValue(`--${state.split(' ')[0]}`);
    pen.fillRect(0, 0, 1, 1);
    const colour = new Uint32Array(pen.getImageData(0, 0, 1, 1).data.buffer)[0]!;
    this.colours.set(state, colour);
    return colour;
  }
}

export function canvasGrid(first: Squares, look: GridLook): Grid {
  const { frame } = first, ratio = look.cellSize[1] / look.cellSize[0]; // height of a cell by its width
  if (Math.max(frame.columns, frame.rows) > MOST_ALONG) return noGrid(`A map of ${frame.columns} by ${frame.rows} cells is too long to be drawn.`);
  const least = Math.min(WIDTH / frame.columns, HEIGHT / (frame.rows * ratio));
  const canvas = el('canvas', { class: 'map', role: 'application', tabindex: '0',
    'aria-label': 'map of cells; the arrow keys move, Enter chooses, plus and minus zoom' });
  canvas.width = Math.max(1, Math.round(Math.min(WIDTH, frame.columns * LARGEST, frame.columns * Math.max(least, 1))));
  canvas.height = Math.max(1, Math.round(Math.min(HEIGHT, frame.rows * ratio * Math.max(least, 1))));
  const picture = new Picture(frame.columns, frame.rows);
  let shown = first, chosen = -1, asked = false, isStale = true;
  let scale = least, [x, y] = [0, 0]; // pixels of a cell's width; the part of the map at the canvas' top left, in pixels

  const draw = () => {
    asked = false;
    const style = getComputedStyle(canvas), pen = canvas.getContext('2d');
    if (!pen) return;
    if (isStale) picture.paint(shown, style);
    isStale = false;
    const [w, h] = [scale, scale * ratio];
    pen.clearRect(0, 0, canvas.width, canvas.height);
    pen.imageSmoothingEnabled = scale < 1;
    pen.drawImage(picture.canvas, x / w, y / h, canvas.width / w, canvas.height / h, 0, 0, canvas.width, canvas.height);
    if (scale >= OUTLINED) outline(pen, style, w, h);
    mark(pen, chosen, style.getPropertyValue('--accent'), 3);
  };
  // Gaps between the cells in sight, and a line around those that are held.
  const outline = (pen: CanvasRenderingContext2D, style: CSSStyleDeclaration, w: number, h: number) => {
    pen.fillStyle = style.getPropertyValue('--ground');
    for (let px = -(x % w); px <= canvas.width; px += w) pen.fillRect(px, 0, 1, canvas.height);
    for (let py = -(y % h); py <= canvas.height; py += h) pen.fillRect(0, py, canvas.width, 1);
    const ink = style.getPropertyValue('--ink');
    for (const k of shown.held ?? []) mark(pen, k, ink, 1.5);
  };
  const mark = (pen: CanvasRenderingContext2D, k: number, colour: string, width: number) => {
    if (k < 0) return;
    pen.strokeStyle = colour;
    pen.lineWidth = width;
    const [column, row] = [k % frame.columns, frame.rows - 1 - Math.floor(k / frame.columns)], size = Math.max(scale, 6);
    pen.strokeRect((column + 0.5) * scale - x - size / 2, (row + 0.5) * scale * ratio - y - size * ratio / 2, size, size * ratio);
  };
  const ask = () => {
    if (!asked) requestAnimationFrame(draw);
    asked = true;
  };
  const moveTo = (left: number, top: number) => {
    x = Math.max(0, Math.min(left, frame.columns * scale - canvas.width));
    y = Math.max(0, Math.min(top, frame.rows * scale * ratio - canvas.height));
    ask();
  };
  // Keeps the place at (px, py) of the canvas where it is.
  const zoom = (factor: number, px = canvas.width / 2, py = canvas.height / 2) => {
    const next = Math.max(least, Math.min(LARGEST, scale * factor)), by = next / scale;
    scale = next;
    moveTo((x + px) * by - px, (y + py) * by - py);
  };
  // The pixel of the canvas below the pointer.
  const pixelOf = (event: MouseEvent): [number, number] => {
    const box = canvas.getBoundingClientRect(), by = canvas.width / box.width;
    return [(event.clientX - box.left) * by, (event.clientY - box.top) * by];
  };
  const cellAt = ([px, py]: [number, number]): number => {
    const k = indexIn(frame, frame.column + Math.floor((x + px) / scale), frame.row + frame.rows - 1 - Math.floor((y + py) / (scale * ratio)));
    return k >= 0 && shown.stateOf(k) ? k : -1;
  };
  const select = (k: number) => {
    chosen = k;
    if (k < 0) return ask();
    canvas.setAttribute('aria-label', shown.textOf(k));
    const [px, py] = [(k % frame.columns + 0.5) * scale, (frame.rows - 0.5 - Math.floor(k / frame.columns)) * scale * ratio];
    const isSeen = px > x && px < x + canvas.width && py > y && py < y + canvas.height;
    if (isSeen) ask();
    else moveTo(px - canvas.width / 2, py - canvas.height / 2);
  };
  addPointer(canvas, { pixelOf, pan: (dx, dy) => moveTo(x - dx, y - dy), zoom, choose: (at) => { const k = cellAt(at); if (k >= 0) look.choose(k); },
    point: (at) => { const k = cellAt(at); canvas.title = k >= 0 ? shown.textOf(k) : ''; } });
  addKeys(canvas, () => shown, () => chosen, select, look.choose);
  canvas.addEventListener('keydown', ({ key }) => {
    if (key === '+' || key === '=') zoom(2);
    if (key === '-') zoom(0.5);
  });
  const button = (text: string, name: string, click: () => void) => el('button', { type: 'button', 'aria-label': name, title: name, click }, text);
  const bar = el('div', { class: 'zoom' }, button('+', 'zoom in', () => zoom(2)), button('\u2212', 'zoom out', () => zoom(0.5)),
    button('all', 'show all cells', () => zoom(0)));
  const repaint = () => { picture.forgetColours(); isStale = true; ask(); };
  const scheme = matchMedia('(prefers-color-scheme: dark)'), ended = new AbortController();
  scheme.addEventListener('change', repaint, { signal: ended.signal });
  ask();
  return { element: el('div', { class: 'canvasmap' }, canvas, bar), update: (next) => { shown = next; isStale = true; ask(); }, select,
    dispose: () => ended.abort() };
}

interface PointerActions {
  pixelOf: (event: MouseEvent) => [number, number];
  pan: (dx: number, dy: number) => void;
  zoom: (factor: number, px: number, py: number) => void;
  choose: (at: [number, number]) => void;
  point: (at: [number, number]) => void;
}

// Drag to move, click to choose, double click to zoom; the wheel zooms where the map has the focus, else scrolls the page.
function addPointer(canvas: HTMLCanvasElement, actions: PointerActions): void {
  let last: [number, number] | null = null, moved = 0;
  canvas.addEventListener('pointerdown', (event) => {
    last = actions.pixelOf(event);
    moved = 0;
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener('pointermove', (event) => {
    const at = actions.pixelOf(event);
    if (!last) return actions.point(at);
    moved += Math.abs(at[0] - last[0]) + Math.abs(at[1] - last[1]);
    actions.pan(at[0] - last[0], at[1] - last[1]);
    last = at;
  });
  canvas.addEventListener('pointerup', (event) => {
    if (last && moved < 5) actions.choose(actions.pixelOf(event));
    last = null;
  });
  canvas.addEventListener('pointercancel', () => { last = null; });
  canvas.addEventListener('dblclick', (event) => actions.zoom(2, ...actions.pixelOf(event)));
  canvas.addEventListener('wheel', (event) => {
    if (document.activeElement !== canvas) return;
    event.preventDefault();
    actions.zoom(event.deltaY < 0 ? 1.25 : 0.8, ...actions.pixelOf(event));
  }, { passive: false });
}
