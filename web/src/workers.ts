// The table of workers: what each does, and since when.
import type { WorkerInfo } from './api';
import { el, number } from './dom';
import { durationText } from './jobs';

const STATES: Record<string, string> = { WORKING: 'at work', DRAINING: 'ending', SET_ASIDE: 'set aside' };

function doingText(worker: WorkerInfo, now: number): string {
  if (worker.doing.length === 0) return 'idle';
  const list = worker.doing.map((t) => `${t.stage.replace('_', ' ')} of cell ${t.col}, ${t.row} (${t.job}, ${
    durationText(Math.max(0, now - Date.parse(t.since)) / 1000)})`);
  const more = worker.tasks - list.length;
  return list.join('; ') + (more > 0 ? `; and ${more} more` : '');
}

export function workersTable(workers: WorkerInfo[]): HTMLElement {
  if (workers.length === 0) return el('p', { class: 'quiet' }, 'No worker is connected. `tilemend-worker --coordinator HOST:PORT` starts one.');
  const now = Date.now();
  return el('div', { class: 'scroll', tabindex: '0', role: 'region', 'aria-label': 'workers' }, el('table', {},
    el('thead', {}, el('tr', {}, ...['worker', 'state', 'tasks', 'doing', 'release', 'remark'].map((text, k) =>
      el('th', { class: k === 2 ? 'number' : '', scope: 'col' }, text)))),
    el('tbody', {}, ...workers.map((w) => el('tr', {},
      el('td', {}, w.id), el('td', {}, w.doing.length === 0 && w.state === 'WORKING' ? 'idle' : STATES[w.state] ?? w.state),
      el('td', { class: 'number' }, `${number(w.tasks)} of ${number(w.threads)}`), el('td', { class: 'doing' }, doingText(w, now)),
      el('td', {}, w.release), el('td', {}, w.message))))));
}
