// The table of workers: what each does, and since when.
import type { WorkerInfo, WorkerTask } from './api';
import { el, number } from './dom';
import { durationText } from './times';
import { stageText } from './stages';

// In the words of `tilemend workers`.
const stateOf = ({ state, tasks }: WorkerInfo): string =>
  (state === 'WORKING' && tasks === 0 ? 'idle' : state.toLowerCase().replaceAll('_', ' '));

// Tasks that it is at, of those that it takes at once, and those that it holds beside them.
function tasksOf({ tasks, threads }: WorkerInfo): string {
  const waiting = Math.max(0, tasks - threads);
  return `${number(tasks - waiting)} of ${number(threads)}${waiting > 0 ? `, ${number(waiting)} waiting` : ''}`;
}

const ago = (time: string, now: number): string => durationText(Math.max(0, now - Date.parse(time)) / 1000);

// What it does, each task with a button that shows its cell.
function doing(worker: WorkerInfo, now: number, choose: (task: WorkerTask) => void): HTMLElement {
  if (worker.doing.length === 0) return el('td', { class: 'doing' }, 'idle');
  const more = worker.tasks - worker.doing.length;
  return el('td', { class: 'doing' }, ...worker.doing.map((task) => el('div', {},
    `${stageText(task.stage)}: `, el('button', { type: 'button', click: () => choose(task) }, `cell ${task.col}, ${task.row}`),
    ` of ${task.job}, for ${ago(task.since, now)}`)), more > 0 ? `and ${more} more` : '');
}

// `choose` hears of a task that was chosen.
export function workersTable(workers: WorkerInfo[], choose: (task: WorkerTask) => void): HTMLElement {
  if (workers.length === 0) return el('p', { class: 'quiet' }, 'No worker is connected. `tilemend-worker --coordinator HOST:PORT` starts one.');
  const now = Date.now();
  return el('div', { class: 'scroll', tabindex: '0', role: 'region', 'aria-label': 'workers' }, el('table', {},
    el('thead', {}, el('tr', {}, ...['worker', 'state', 'tasks', 'doing', 'heard of', 'release', 'remark'].map((text, k) =>
      el('th', { class: k === 2 ? 'number' : '', scope: 'col' }, text)))),
    el('tbody', {}, ...workers.map((w) => el('tr', {},
      el('td', {}, w.id), el('td', {}, stateOf(w)),
      el('td', { class: 'number' }, tasksOf(w)), doing(w, now, choose),
      el('td', {}, `${ago(w.lastSeen, now)} ago`),
      el('td', {}, w.release), el('td', {}, w.message))))));
}
