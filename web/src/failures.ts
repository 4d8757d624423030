// What failed in a job, with the lines of the log that tell of it.
import type { Cells, Failure } from './api';
import { counted, el } from './dom';
import { stageText } from './stages';

const MOST_LINES = 8;      // below one failure
const MOST_FAILURES = 200; // as the coordinator has it

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
  private shown = '';

  // `choose` hears of a cell.
  constructor(private readonly choose: (cell: [number, number]) => void) {
    this.element.append(this.list, this.logBox);
  }

  update(cells: Cells, lines: string[]): void {
    const text = lines.length > 0 ? lines.join('\n') : 'There are no log lines of this job. Log lines are kept until the coordinator restarts.';
    if (this.log.textContent !== text) this.log.textContent = text;
    const { failures } = cells;
    const now = JSON.stringify(failures.map((failure) => [failure, evidenceOf(failure, lines)]));
    if (now === this.shown) return; // whose button has the focus keeps it
    this.shown = now;
    if (failures.length === 0) return this.list.replaceChildren();
    const row = (failure: Failure) => {
      const evidence = evidenceOf(failure, lines);
      return el('tr', {},
        el('td', {}, el('button', { type: 'button', click: () => this.choose(failure.cell) }, failure.cell.join(', '))),
        el('td', {}, stageText(failure.stage)),
        el('td', {}, failure.reason, ...(evidence.length > 0 ? [el('pre', { class: 'log' }, evidence.join('\n'))] : [])));
    };
    const title = failures.length < MOST_FAILURES ? counted(failures.length, 'failed task') : `The first ${MOST_FAILURES} failed tasks`;
    this.list.replaceChildren(el('h2', {}, title),
      el('div', { class: 'scroll', tabindex: '0', role: 'region', 'aria-label': 'failed tasks' }, el('table', { class: 'failures' },
        el('thead', {}, el('tr', {}, ...['cell', 'step', 'why, and what the log says'].map((text) => el('th', { scope: 'col' }, text)))),
        el('tbody', {}, ...failures.map(row)))));
  }
}
