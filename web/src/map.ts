// The grid of cells of a report, coloured by what became of their holes.
import type { Cell, Report } from './data';
import { el } from './dom';
import { legendOf, makeGrid } from './grid';

const NAMES: [string, string][] = [
  ['left', 'holes left open'], ['filled', 'all holes filled'], ['whole', 'no hole'], ['empty', 'no tile']];

function stateOf([, , filled, left, tile]: Cell): string {
  if (left > 0) return 'left';
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
  const grid = makeGrid(report.cells.map((cell) => ({ column: cell[0], row: cell[1], cell })), {
    stateOf: ({ cell }) => stateOf(cell), textOf: ({ cell }) => textOf(cell), choose: ({ cell }) => choose(cell),
    cellSize: report.grid?.cell_size ?? [1, 1] });
  return el('div', { class: 'mapbox' }, el('div', { class: 'scroll' }, grid.element),
    legendOf(NAMES, new Set(report.cells.map(stateOf))));
}
