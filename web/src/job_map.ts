// The map of a job: how far each cell is, with what became of its holes.
import type { Cells, Holes } from './api';
import { type Frame, indexIn, type Squares } from './grid';

const STATES: Record<string, string> = {
  '-': 'empty', '?': 'unknown', '.': 'waiting', s: 'surveyed', p: 'planned', f: 'filling', F: 'closed', w: 'written', x: 'failed' };
export const STATE_NAMES: [string, string][] = [
  ['waiting', 'waiting'], ['surveyed', 'surveyed'], ['planned', 'planned'], ['filling', 'filling'],
  ['closed', 'filled'], ['written', 'written'], ['left', 'holes left open'], ['failed', 'failed'], ['unknown', 'not known'], ['empty', 'no tile'],
  ['held', 'a worker has it']];

// Letters of cells whose fills are there.
const FILLED = 'Fw';

export class JobMap implements Squares {
  readonly frame: Frame;
  readonly held: Set<number>;
  private readonly counts = new Map<number, [number, number, number]>(); // holes, those that stay open, and those that count as left, by cell

  constructor(readonly cells: Cells, private readonly holes: Holes | null) {
    this.frame = { column: cells.column, row: cells.row, columns: cells.columns, rows: cells.rows };
    this.held = new Set(cells.held.map(([column, row]) => indexIn(this.frame, column, row)));
    for (const hole of holes?.holes ?? []) {
      const k = this.indexOf(hole.cell), [all, open, left] = this.counts.get(k) ?? [0, 0, 0];
      this.counts.set(k, [all + 1, open + (hole.filled ? 0 : 1), left + (hole.counts ? 1 : 0)]);
    }
  }

  indexOf(cell: [number, number]): number { return indexIn(this.frame, cell[0], cell[1]); }
  cellOf(k: number): [number, number] {
    return [this.frame.column + k % this.frame.columns, this.frame.row + Math.floor(k / this.frame.columns)];
  }
  // Whether the cell's holes are filled.
  isFilled(cell: [number, number]): boolean { return FILLED.includes(this.cells.cells[this.indexOf(cell)] ?? ' '); }

  readonly stateOf = (k: number): string => {
    const letter = this.cells.cells[k];
    if (letter === undefined || letter === ' ') return '';
    const state = this.nameOf(k, letter);
    return this.held.has(k) ? `${state} held` : state;
  };

  readonly textOf = (k: number): string => {
    const [column, row] = this.cellOf(k), state = this.stateOf(k).split(' ')[0];
    const name = STATE_NAMES.find(([name]) => name === state)?.[1] ?? '', [all, open] = this.counts.get(k) ?? [0, 0];
    const holes = all === 0 ? '' : this.holes?.planned ? `, ${all} to fill${open > 0 ? `, ${open} of them stay open` : ''}`
      : `, ${all - open} filled, ${open} left open`;
    return `cell ${column}, ${row}: ${name}${this.held.has(k) ? ', a worker has it' : ''}${holes}`;
  };

  // Those that are there.
  states(): Set<string> {
    const letters = new Set(this.cells.cells), ofHoles = [...this.counts.keys()].filter((k) => k >= 0);
    letters.delete(' ');
    const made = ofHoles.filter((k) => this.cells.cells[k] === '-' && this.nameOf(k, '-') !== 'empty');
    if (made.length > 0 && made.length === this.cells.cells.split('-').length - 1) letters.delete('-');
    const states = new Set([...letters].map((letter) => STATES[letter] ?? 'waiting'));
    for (const k of ofHoles) states.add(this.nameOf(k, this.cells.cells[k] ?? ' '));
    if (this.held.size > 0) states.add('held');
    return states;
  }

  // A cell without a tile gets one by its fill. After a restart the coordinator does not know that, but the report does.
  private nameOf(k: number, letter: string): string {
    if (this.leftIn(k) > 0 && letter !== 'x') return 'left';
    const [all, open] = this.counts.get(k) ?? [0, 0];
    if (letter === '-' && all > open && this.holes && !this.holes.planned) return 'written';
    return STATES[letter] ?? 'waiting';
  }

  private leftIn(k: number): number { return this.counts.get(k)?.[2] ?? 0; }
}
