// One job: its map as it goes, its holes, its failures, and its cells before and after.
import type { WebGLRenderer } from 'three';
import { type Cells, type Holes, type Job, ApiError, get } from './api';
import type { Hole } from './data';
import { counted, el, number } from './dom';
import { type Grid, legendOf, makeGrid, type Square } from './grid';
import { holesTable, type HolesTable } from './holes';
import { isOver } from './jobs';
import { Card, makeRenderer } from './pictures';
import { readCell } from './tile';

const LETTERS: Record<string, string> = {
  '-': 'empty', '.': 'waiting', s: 'surveyed', p: 'planned', f: 'filling', F: 'closed', w: 'written', x: 'failed' };
const NAMES: [string, string][] = [
  ['waiting', 'waiting'], ['surveyed', 'surveyed'], ['planned', 'planned'], ['filling', 'filling'],
  ['closed', 'filled'], ['written', 'written'], ['left', 'holes left open'], ['failed', 'failed'], ['empty', 'no tile']];

interface MapCell extends Square { state: string; held: boolean; filled: number; left: number }

const keyOf = (column: number, row: number): string => `${column},${row}`;

function cellsOf(map: Cells, holes: Holes | null): MapCell[] {
  const held = new Set(map.held.map(([c, r]) => keyOf(c, r)));
  const counts = new Map<string, [number, number]>();
  for (const hole of holes?.holes ?? []) {
    const key = keyOf(hole.cell[0], hole.cell[1]), [filled, left] = counts.get(key) ?? [0, 0];
    counts.set(key, hole.filled ? [filled + 1, left] : [filled, left + 1]);
  }
  const cells: MapCell[] = [];
  for (let k = 0; k < map.cells.length; ++k) {
    const letter = map.cells[k]!;
    if (letter === ' ') continue;
    const column = map.column + k % map.columns, row = map.row + Math.floor(k / map.columns);
    const [filled, left] = counts.get(keyOf(column, row)) ?? [0, 0];
    const state = left > 0 && letter !== 'x' ? 'left' : LETTERS[letter] ?? 'waiting';
    cells.push({ column, row, state, held: held.has(keyOf(column, row)), filled, left });
  }
  return cells;
}

function textOf(cell: MapCell): string {
  const name = NAMES.find(([state]) => state === cell.state)?.[1] ?? cell.state;
  const holes = cell.filled + cell.left > 0 ? `, ${cell.filled} filled, ${cell.left} left open` : '';
  return `cell ${cell.column}, ${cell.row}: ${name}${cell.held ? ', a worker has it' : ''}${holes}`;
}

let renderer: WebGLRenderer | null | undefined;

export class JobView {
  readonly element = el('section', { class: 'jobview' });
  private readonly mapBox = el('div', { class: 'mapbox' });
  private readonly detail = el('div', { class: 'detail' });
  private readonly failures = el('div', {});
  private readonly warnings = el('div', {});
  private readonly holesBox = el('div', {});
  private grid: Grid<MapCell> | null = null;
  private cells: MapCell[] = [];
  private shape = '';
  private map: Cells | null = null;
  private holes: Holes | null = null;
  private table: HolesTable | null = null;

  constructor(private readonly name: string) {
    this.element.append(el('h2', {}, `Map of ${name}`),
      el('div', { class: 'mapanddetail' }, this.mapBox, this.detail), this.warnings, this.failures, this.holesBox);
  }

  async poll(job: Job): Promise<void> {
    const map = await get<Cells>(`/v1/${this.name}/cells`);
    const holes = isOver(job) && job.report ? await this.readHoles() : null;
    this.warnings.replaceChildren(...job.warnings.map((text) => el('p', { class: 'warning' }, text)));
    if (map === this.map && holes === this.holes) return;
    const newHoles = holes !== this.holes;
    this.map = map;
    this.holes = holes;
    this.draw(map);
    this.drawFailures(map);
    if (newHoles) this.drawHoles();
  }

  private async readHoles(): Promise<Holes | null> {
    try {
      return await get<Holes>(`/v1/${this.name}/holes`);
    } catch (error) {
      if (error instanceof ApiError && error.status >= 400) return null; // its folder is gone
      throw error;
    }
  }

  private draw(map: Cells): void {
    this.cells = cellsOf(map, this.holes);
    const shape = [map.column, map.row, map.columns, map.rows, this.cells.length].join();
    if (this.cells.length === 0) {
      this.grid = null;
      this.mapBox.replaceChildren(el('p', { class: 'quiet' }, 'The cells are not known yet.'));
      return;
    }
    const there = new Set(this.cells.map((cell) => cell.state));
    const legend = legendOf(NAMES, there);
    if (this.grid && shape === this.shape) {
      this.grid.update(this.cells);
      this.mapBox.lastElementChild?.replaceWith(legend);
      return;
    }
    this.shape = shape;
    this.grid = makeGrid<MapCell>(this.cells, {
      stateOf: (cell) => cell.state + (cell.held ? ' held' : ''), textOf, choose: (cell) => this.chooseCell(cell),
      cellSize: map.cellSize ?? [1, 1] });
    this.mapBox.replaceChildren(el('div', { class: 'scroll' }, this.grid.element), legend);
    if (this.detail.childElementCount === 0) {
      this.detail.append(el('p', { class: 'quiet' }, 'Choose a cell of the map or a hole of the table to see more of it.'));
    }
  }

  private chooseCell(cell: MapCell): void {
    this.grid?.select(cell);
    this.table?.showCell([cell.column, cell.row]);
    this.showDetail(cell, null);
  }

  private chooseHole(hole: Hole): void {
    const cell = this.cells.find((c) => c.column === hole.cell[0] && c.row === hole.cell[1]);
    if (!cell) return;
    this.grid?.select(cell);
    this.showDetail(cell, hole);
    this.detail.scrollIntoView({ behavior: 'smooth', block: 'nearest' });
  }

  private showDetail(cell: MapCell, hole: Hole | null): void {
    const text = hole ? `Hole ${hole.id}, ${number(hole.area, 1)} m\u00b2, in cell ${cell.column}, ${cell.row}` : textOf(cell);
    const parts: HTMLElement[] = [el('p', { role: 'status' }, text)];
    if (this.map?.hasTiles) {
      const button = el('button', { type: 'button', click: () => this.showPicture(cell, hole, button) }, 'show before and after');
      parts.push(button);
    }
    this.detail.replaceChildren(...parts);
  }

  private showPicture(cell: MapCell, hole: Hole | null, button: HTMLElement): void {
    renderer ??= makeRenderer();
    if (!renderer) {
      button.replaceWith(el('p', {}, 'This browser has no WebGL, so there are no pictures.'));
      return;
    }
    const card = new Card(() => readCell(this.name, [cell.column, cell.row], hole),
      hole ? `hole ${hole.id} in cell ${cell.column}, ${cell.row}` : `cell ${cell.column}, ${cell.row}`,
      'Drag to turn, click and use the wheel to zoom. \u201cMarked\u201d shows new surface in blue.');
    button.replaceWith(card.element);
    void card.load(renderer);
  }

  private drawFailures(map: Cells): void {
    if (map.failures.length === 0) return this.failures.replaceChildren();
    this.failures.replaceChildren(el('h2', {}, counted(map.failures.length, 'failed task')),
      el('div', { class: 'scroll', tabindex: '0', role: 'region', 'aria-label': 'failed tasks' }, el('table', {},
        el('thead', {}, el('tr', {}, ...['cell', 'stage', 'why'].map((text) => el('th', { scope: 'col' }, text)))),
        el('tbody', {}, ...map.failures.map((f) => el('tr', {}, el('td', {}, f.cell.join(', ')),
          el('td', {}, f.stage.replace('_', ' ')), el('td', {}, f.reason)))))));
  }

  private drawHoles(): void {
    if (!this.holes) return this.holesBox.replaceChildren();
    this.table = holesTable({ per_hole: this.holes.holes, hole_count: this.holes.holeCount }, (hole) => this.chooseHole(hole));
    this.holesBox.replaceChildren(el('h2', {}, 'Holes'), this.table.element);
  }
}
