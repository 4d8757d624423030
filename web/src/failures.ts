// What failed in a job, with the lines of the log that tell of it.
import type { Cells, Failure } from './api';
import { counted, el } from './dom';

const MOST_LINES = 8; // below one failure

// A cell as the log writes it.
function logName([column, row]: [number, number]): string {
  const part = (n: number) => `${n < 0 ? '-' : '+'}${String(Math.abs(n)).padStart(3, '0')}`;
  return `cell=${part(column)}_${part(row)}`;
}

// The lines on attempts at that task.
function evidenceOf({ cell, stage }: Failure, lines: string[]): string[] {
  const words = [logName(cell), `stage=${stage}`];
  return lines.filter((line) => words.every((word) => line.split(' ').includes(word))).slice(-MOST_LINES);
}

export class Failures {
  readonly element = el('div', {});
  private readonly log = el('pre', { class: 'log', tabindex: '0', 'aria-label': 'log lines of the job' });
  private readonly logBox = el('details', { class: 'joblog' }, el('summary', {}, 'Log of the job'), this.log);
  private readonly list = el('div', {});

  // `choose` hears of a cell.
  constructor(private readonly choose: (cell: [number, number]) => void) {
    this.element.append(this.list, this.logBox);
  }

  update(cells: Cells, lines: string[]): void {
    this.log.textContent = lines.length > 0 ? lines.join('\n') : 'This coordinator has no lines of the job.';
    const { failures } = cells;
    if (failures.length === 0) return this.list.replaceChildren();
    const row = (failure: Failure) => {
      const evidence = evidenceOf(failure, lines);
      return el('tr', {},
        el('td', {}, el('button', { type: 'button', click: () => this.choose(failure.cell) }, failure.cell.join(', '))),
        el('td', {}, failure.stage.replace('_', ' ')),
        el('td', {}, failure.reason, ...(evidence.length > 0 ? [el('pre', { class: 'log' }, evidence.join('\n'))] : [])));
    };
    this.list.replaceChildren(el('h2', {}, counted(failures.length, 'failed task')),
      el('div', { class: 'scroll', tabindex: '0', role: 'region', 'aria-label': 'failed tasks' }, el('table', { class: 'failures' },
        el('thead', {}, el('tr', {}, ...['cell', 'stage', 'why, and what the log says'].map((text) => el('th', { scope: 'col' }, text)))),
        el('tbody', {}, ...failures.map(row)))));
  }
}
