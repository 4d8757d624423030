// The grid of cells of a report, coloured by what became of their holes.
import type { Cell, Report } from './data';
import { el } from './dom';
import { frameOf, indexIn, legendOf, makeGrid } from './grid';

const NAMES: [string, string][] = [
  ['left', 'holes left open'], ['uncounted', 'what is left open does not count'], ['filled', 'all holes filled'], ['whole', 'no hole'], ['empty', 'no tile']];

function stateOf([, , filled, left, tile, counting]: Cell): string {
  if (left > 0) return counting > 0 ? 'left' : 'uncounted';
  if (filled > 0) return 'filled';
  return tile ? 'whole' : 'empty';
}

function textOf(cell: Cell): string {
  const [column, row, filled, left] = cell;
  return `cell ${column}, ${row}: ${filled} filled, ${left} left open`;
}

// `choose` hears of a cell that was clicked.
export function cellMap(report: Report, choose: (cell: Cell) => void): HTMLElement {
  if (report.cells.length === 0) return el('p', {}, 'The report names no cell.');
  const frame = frameOf(report.cells.map(([column, row]) => ({ column, row })));
  const cells = new Map(report.cells.map((cell) => [indexIn(frame, cell[0], cell[1]), cell]));
  const grid = makeGrid({ frame, stateOf: (k) => { const cell = cells.get(k); return cell ? stateOf(cell) : ''; },
    textOf: (k) => textOf(cells.get(k)!) }, { choose: (k) => choose(cells.get(k)!), cellSize: report.grid?.cell_size ?? [1, 1] });
  return el('div', { class: 'mapbox' }, grid.element, legendOf(NAMES, new Set(report.cells.map(stateOf))));
}
