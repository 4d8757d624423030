// The page of a coordinator: asks every two seconds and shows what has changed.
import { ApiError, get, hasToken, type Job, type Me, setToken, type WorkerInfo, type WorkerTask } from './api';
import { el } from './dom';
import { JobView } from './job';
import { JobList, Rates } from './jobs';
import { workersTable } from './workers';

const INTERVAL = 2000; // milliseconds

const note = el('p', { class: 'warning', role: 'alert' });
const who = el('span', { class: 'quiet' });
const workersBox = el('div', {}), viewBox = el('div', {});
const rates = new Rates();
let chosen = location.hash.slice(1);
let view: JobView | null = null;
let workers: WorkerInfo[] | null = null;
let timer = 0;

function say(error: unknown): void {
  note.textContent = error === null ? '' : error instanceof Error ? error.message : String(error);
  note.hidden = error === null;
}

const list = new JobList({
  choose: (job) => { location.hash = job.name; },
  failed: say,
  changed: () => { void pollSoon(0); } });

function loginForm(): HTMLFormElement {
  const input = el('input', { type: 'password', autocomplete: 'off', id: 'token', required: '' });
  return el('form', { class: 'login', submit: (event) => {
    event.preventDefault();
    setToken(input.value.trim());
    void pollSoon(0);
  } }, el('label', { for: 'token' }, 'Token'), input, el('button', { type: 'submit' }, 'use it'),
  el('p', { class: 'quiet' }, 'This coordinator wants to know who calls. The token stays in this tab.'));
}

const login = loginForm();
const logout = el('button', { type: 'button', hidden: '', click: () => { setToken(''); void pollSoon(0); } }, 'forget the token');
const content = el('div', {}, el('section', {}, el('h2', {}, 'Jobs'), list.element), viewBox,
  el('section', {}, el('h2', {}, 'Workers'), workersBox));

// The cell of a task, once its job's map is there.
let wanted: WorkerTask | null = null;

function showTask(task: WorkerTask): void {
  wanted = task;
  if (chosen === task.job) void pollSoon(0);
  else location.hash = task.job;
}

function choose(jobs: Job[]): void {
  if (!jobs.some((job) => job.name === chosen)) chosen = jobs[0]?.name ?? '';
  if (chosen === view?.element.dataset['job']) return;
  view = chosen ? new JobView(chosen) : null;
  if (view) view.element.dataset['job'] = chosen;
  viewBox.replaceChildren(...(view ? [view.element] : []));
}

async function poll(): Promise<void> {
  const me = await get<Me>('/v1/me');
  const { jobs } = await get<{ jobs: Job[] }>('/v1/jobs?pageSize=200');
  const seen = await get<{ workers: WorkerInfo[] }>('/v1/workers?pageSize=1000');
  login.hidden = true;
  content.hidden = false;
  logout.hidden = !hasToken();
  who.textContent = me.name ? `${me.name}${me.isAdmin ? ', administrator' : me.maySteer ? '' : ', may watch'}` : '';
  jobs.forEach((job) => rates.add(job, Date.now()));
  choose(jobs);
  list.update(jobs, me, rates, chosen);
  // Who is at one of its buttons is not disturbed.
  if (seen.workers !== workers && !workersBox.contains(document.activeElement)) {
    workersBox.replaceChildren(workersTable(seen.workers, showTask));
    workers = seen.workers;
  }
  const job = jobs.find((j) => j.name === chosen);
  if (!view || !job) return;
  await view.poll(job);
  if (wanted?.job === chosen) view.chooseCell([wanted.col, wanted.row]);
  wanted = null;
}

async function pollOnce(): Promise<void> {
  try {
    await poll();
    say(null);
  } catch (error) {
    const needsToken = error instanceof ApiError && error.status === 401;
    login.hidden = !needsToken;
    content.hidden = needsToken;
    if (needsToken && !hasToken()) say(null);
    else say(error instanceof ApiError && error.status === 0 ? new Error('The coordinator does not answer. Trying again.') : error);
  }
  document.body.dataset['polls'] = String(Number(document.body.dataset['polls'] ?? 0) + 1);
}

let running: Promise<void> | null = null;

// One poll at a time, then the next after the interval.
async function pollSoon(delay: number): Promise<void> {
  clearTimeout(timer);
  timer = window.setTimeout(async () => {
    if (running) await running;
    running = document.hidden ? Promise.resolve() : pollOnce();
    await running;
    running = null;
    void pollSoon(INTERVAL);
  }, delay);
}

addEventListener('hashchange', () => { chosen = location.hash.slice(1); void pollSoon(0); });
document.addEventListener('visibilitychange', () => { if (!document.hidden) void pollSoon(0); });
say(null);
login.hidden = content.hidden = true;
document.getElementById('page')?.replaceChildren(
  el('header', {}, el('h1', {}, 'tilemend coordinator'), el('div', { class: 'who' }, who, logout)), note, login, content);
void pollSoon(0);
