// The page of a coordinator: asks every two seconds and shows what has changed.
import { ApiError, get, getAll, hasToken, isToken, type Job, type Me, setToken, type WorkerInfo, type WorkerTask } from './api';
import { el } from './dom';
import { JobView } from './job';
import { JobList } from './jobs';
import { Rates } from './times';
import { workersTable } from './workers';

const INTERVAL = 2000;     // milliseconds
const MOST_JOBS = 1000;    // in the list
const MOST_WORKERS = 4096; // as the coordinator has it

const note = el('p', { class: 'warning', role: 'alert' });       // of the polls
const actionNote = el('p', { class: 'warning', role: 'alert' }); // of what the user asked for, until the next time
const who = el('span', { class: 'quiet' });
const workersBox = el('div', {}), viewBox = el('div', {});
const rates = new Rates();
let chosen = location.hash.slice(1);
let view: JobView | null = null;
let timer = 0;

// A screen reader reads a text again when it is set, even to the same.
function say(error: unknown, where = note): void {
  const text = error === null ? '' : error instanceof Error ? error.message : String(error);
  if (where.textContent !== text) where.textContent = text;
  where.hidden = text === '';
}

const list = new JobList({
  choose: (job) => { location.hash = job.name; },
  failed: (error) => say(error, actionNote),
  changed: () => { say(null, actionNote); void pollSoon(0); } });

function loginForm(): HTMLFormElement {
  const input = el('input', { type: 'password', autocomplete: 'off', id: 'token', required: '' });
  return el('form', { class: 'login', submit: (event) => {
    event.preventDefault();
    const token = input.value.trim();
    input.value = '';
    if (!isToken(token)) return say(new Error('A token has only letters, digits and signs of ASCII, without spaces. Copy it again.'), actionNote);
    setToken(token);
    say(null, actionNote);
    void pollSoon(0);
  } }, el('label', { for: 'token' }, 'Token'), input, el('button', { type: 'submit' }, 'use it'),
  el('p', { class: 'quiet' }, 'This coordinator wants to know who calls. The token stays in this tab.'));
}

const login = loginForm();
const logout = el('button', { type: 'button', hidden: '', click: () => { setToken(''); void pollSoon(0); } }, 'forget the token');
const jobsNote = el('p', { class: 'quiet' });
const content = el('div', {}, el('section', {}, el('h2', {}, 'Jobs'), list.element, jobsNote), viewBox,
  el('section', {}, el('h2', {}, 'Workers'), workersBox));

// The cell of a task, once its job's map is there.
let wanted: WorkerTask | null = null;

function showTask(task: WorkerTask): void {
  wanted = task;
  if (chosen === task.job) void pollSoon(0);
  else location.hash = task.job;
}

function choose(jobs: Job[]): void {
  if (!jobs.some((job) => job.name === chosen)) {
    if (chosen) say(new Error(`There is no job "${chosen}" any more.`), actionNote);
    chosen = jobs[0]?.name ?? '';
  }
  if (chosen === view?.element.dataset['job']) return;
  view?.dispose();
  view = chosen ? new JobView(chosen) : null;
  if (view) view.element.dataset['job'] = chosen;
  viewBox.replaceChildren(...(view ? [view.element] : []));
}

// The newest, and the chosen one if it is older.
async function readJobs(): Promise<Job[]> {
  const { items, isAll } = await getAll<Job>('/v1/jobs?pageSize=200', 'jobs', MOST_JOBS);
  jobsNote.textContent = isAll ? '' : `The newest ${items.length} jobs are listed. An older one is at the address of this page with #jobs/ID.`;
  if (isAll || !/^jobs\/[^/]+$/.test(chosen) || items.some((job) => job.name === chosen)) return items;
  try {
    return [...items, await get<Job>(`/v1/${chosen}`)];
  } catch (error) {
    if (error instanceof ApiError && error.status === 404) return items;
    throw error;
  }
}

// Who is at one of its buttons, or marks a text, is not disturbed.
function showWorkers(workers: WorkerInfo[]): void {
  const active = document.activeElement, hasFocus = workersBox.contains(active);
  if (hasFocus && active instanceof HTMLButtonElement) return;
  const marked = getSelection();
  if (marked && !marked.isCollapsed && workersBox.contains(marked.anchorNode)) return;
  const before = workersBox.firstElementChild?.scrollLeft ?? 0;
  workersBox.replaceChildren(workersTable(workers, showTask));
  const table = workersBox.firstElementChild as HTMLElement;
  table.scrollLeft = before;
  if (hasFocus) table.focus({ preventScroll: true });
}

async function poll(): Promise<void> {
  const me = await get<Me>('/v1/me');
  const jobs = await readJobs();
  const { items: workers } = await getAll<WorkerInfo>('/v1/workers?pageSize=1000', 'workers', MOST_WORKERS);
  login.hidden = true;
  content.hidden = false;
  who.textContent = me.name ? `${me.name}${me.isAdmin ? ', administrator' : me.maySteer ? '' : ', may watch'}` : '';
  jobs.forEach((job) => rates.add(job, Date.now()));
  choose(jobs);
  list.update(jobs, me, rates, chosen);
  showWorkers(workers);
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
    // 403: known, but without a role that may watch. Another token may have one.
    const needsToken = error instanceof ApiError && (error.status === 401 || (error.status === 403 && hasToken()));
    login.hidden = !needsToken;
    content.hidden = needsToken;
    if (needsToken) who.textContent = '';
    if (needsToken && !hasToken()) say(null);
    else say(error instanceof ApiError && error.status === 0 ? new Error('The coordinator does not answer. Trying again.') : error);
  }
  logout.hidden = !hasToken();
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
say(null, actionNote);
login.hidden = content.hidden = true;
document.getElementById('page')?.replaceChildren(
  el('header', {}, el('h1', {}, 'tilemend coordinator'), el('div', { class: 'who' }, who, logout)), note, actionNote, login, content);
void pollSoon(0);
