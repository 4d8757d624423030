// The list of jobs: how far each is, how fast it goes, and what may be done with it.
import { ApiError, type Job, type Me, post } from './api';
import { el, number } from './dom';
import { stageText } from './stages';
import { durationText, type Rates, shareDone } from './times';

// In the words of `tilemend list`, except that a partial job says what is left.
export function stateText(job: Job): string {
  switch (job.state) {
    case 'RUNNING': return job.paused ? 'paused' : job.waiting ? 'waiting' : 'running';
    case 'DONE': return 'done';
    case 'PARTIAL': {
      const left = Number(job.progress.holes) - Number(job.progress.holesFilled);
      return left > 0 ? `done, ${number(left)} left open` : 'done, but not all of it';
    }
    case 'FAILED': return 'failed';
    default: return 'cancelled';
  }
}

export const isOver = (job: Job): boolean => job.state !== 'RUNNING';

function speedText(job: Job, rates: Rates, now: number): string {
  // From its creation on, as `tilemend get` has it.
  const took = isOver(job) ? durationText((Date.parse(job.endTime ?? '') - Date.parse(job.createTime)) / 1000) : '';
  if (isOver(job)) return took && `took ${took}`;
  return job.paused || job.waiting ? '' : rates.textOf(job, now);
}

// What the bar shows: tasks while they go, as cells are written late.
function progressTexts(job: Job): string[] {
  const { progress } = job, done = Number(progress.cellsDone);
  const cells = `${number(done)} of ${number(Number(progress.cells))} cells`;
  if (isOver(job)) return [cells];
  return [stageText(progress.phase), `${number(Number(progress.tasksDone))} of ${number(Number(progress.tasks))} tasks`, done > 0 ? `${cells} written` : ''];
}

const baseName = (path: string): string => path.replace(/\/+$/, '').split('/').pop() || path;

export interface JobActions { choose: (job: Job) => void; failed: (error: unknown) => void; changed: () => void }

const PATIENCE = 5000; // milliseconds that a button waits for the second click

// A button that asks once more before it acts: until PATIENCE is over or it loses the focus.
class Confirmation {
  private readonly text: string;
  private timer = 0;
  private isArmed = false;

  constructor(private readonly button: HTMLButtonElement) {
    this.text = button.textContent ?? '';
    button.addEventListener('blur', () => this.disarm());
  }

  arm(question: string): void {
    clearTimeout(this.timer);
    this.isArmed = true;
    this.button.textContent = question;
    this.timer = window.setTimeout(() => this.disarm(), PATIENCE);
  }

  // Whether it was armed.
  disarm(): boolean {
    const before = this.isArmed;
    clearTimeout(this.timer);
    this.isArmed = false;
    this.button.textContent = this.text;
    return before;
  }
}

function steerButtons(job: () => Job, actions: JobActions): { element: HTMLElement; update: (me: Me) => void } {
  const run = (verb: string, body: unknown, failed = actions.failed) => {
    post(`/v1/${job().name}/${verb}`, body).then((answer) => {
      if (answer.name !== job().name) actions.choose(answer); // it is done again, as a job of its own
      actions.changed();
    }, failed);
  };
  const button = (text: string, click: () => void) => el('button', { type: 'button', click }, text);
  const pause = button('pause', () => run(job().paused ? 'resume' : 'pause', {}));
  const cancel = button('cancel', () => {
    if (cancelTwice.disarm()) run('cancel', {});
    else cancelTwice.arm('really cancel?');
  });
  const cancelTwice = new Confirmation(cancel);
  // An output that is there is replaced only after a second click.
  const retry = button('retry', () => {
    const overwrite = retryTwice.disarm();
    run('retry', { requestId: crypto.randomUUID?.() ?? String(Math.random()), overwrite }, (error) => {
      if (error instanceof ApiError && error.reason === 'OUTPUT_EXISTS' && !overwrite) retryTwice.arm('replace its output?');
      else actions.failed(error);
    });
  });
  const retryTwice = new Confirmation(retry);
  const priority = el('input', { type: 'number', min: '-100', max: '100', class: 'priority', 'aria-label': 'priority', title: 'priority',
    change: () => { if (priority.value !== '') run('priority', { priority: Number(priority.value) }); } });
  const element = el('div', { class: 'steer' }, pause, cancel, retry, el('label', {}, 'priority ', priority));
  const update = (me: Me) => {
    const over = isOver(job());
    element.hidden = !(me.isAdmin || (me.maySteer && job().owner === me.name));
    pause.hidden = cancel.hidden = priority.parentElement!.hidden = over;
    retry.hidden = !over;
    pause.textContent = job().paused ? 'resume' : 'pause';
    if (document.activeElement !== priority) priority.value = String(job().priority);
  };
  return { element, update };
}

class JobCard {
  readonly element: HTMLElement;
  private readonly title = el('button', { type: 'button', class: 'name' });
  private readonly state = el('span', { class: 'state' });
  private readonly bar = el('progress', { max: '1', value: '0' });
  private readonly facts = el('span', { class: 'quiet' });
  private readonly speed = el('span', { class: 'quiet speed' });
  private readonly why = el('p', { class: 'quiet' });
  private readonly steer;

  constructor(private job: Job, actions: JobActions) {
    this.steer = steerButtons(() => this.job, actions);
    this.title.addEventListener('click', () => actions.choose(this.job));
    this.element = el('article', { class: 'job' },
      el('div', { class: 'line' }, this.title, this.state, this.speed), this.bar,
      el('div', { class: 'line' }, this.facts, this.steer.element), this.why);
  }

  update(job: Job, me: Me, rates: Rates, chosen: boolean, now: number): void {
    this.job = job;
    const { progress } = job;
    this.title.textContent = `${job.name} \u00b7 ${baseName(job.spec.scene)} \u2192 ${baseName(job.spec.out)}`;
    this.title.title = `${job.spec.scene} \u2192 ${job.spec.out}`;
    this.title.setAttribute('aria-pressed', String(chosen));
    this.state.textContent = stateText(job);
    this.state.title = job.state === 'PARTIAL' ? 'done, but some holes are left open' : '';
    this.state.className = `state ${job.state.toLowerCase()}`;
    const share = (done: string, all: string) => (Number(all) > 0 ? Number(done) / Number(all) : 0);
    this.bar.value = job.state === 'DONE' || job.state === 'PARTIAL' ? 1
      : isOver(job) ? share(progress.cellsDone, progress.cells) : shareDone(job);
    this.bar.setAttribute('aria-label', `progress of ${job.name}`);
    this.facts.textContent = [...progressTexts(job),
      Number(progress.holes) > 0 ? `${number(Number(progress.holesFilled))} of ${number(Number(progress.holes))} holes filled` : '',
      job.owner ? `by ${job.owner}` : ''].filter(Boolean).join(' \u00b7 ');
    this.speed.textContent = speedText(job, rates, now);
    const message = isOver(job) && !this.facts.textContent.includes(job.message) ? job.message : '';
    this.why.textContent = job.error?.message || (job.paused ? '' : job.waiting) || message;
    this.why.hidden = this.why.textContent === '';
    this.element.classList.toggle('chosen', chosen);
    this.element.classList.toggle('partial', job.state === 'PARTIAL');
    this.steer.update(me);
  }
}

// Cards that stay where they are while their jobs change.
export class JobList {
  readonly element = el('div', { class: 'jobs' });
  private readonly cards = new Map<string, JobCard>();
  private readonly none = el('p', { class: 'quiet' }, 'No job yet. `tilemend submit SCENE --out DIR --coordinator HOST:PORT` makes one.');

  constructor(private readonly actions: JobActions) {}

  update(jobs: Job[], me: Me, rates: Rates, chosen: string): void {
    const now = Date.now();
    const elements = jobs.map((job) => {
      const card = this.cards.get(job.name) ?? new JobCard(job, this.actions);
      this.cards.set(job.name, card);
      card.update(job, me, rates, job.name === chosen, now);
      return card.element;
    });
    const names = new Set(jobs.map((job) => job.name));
    for (const name of this.cards.keys()) if (!names.has(name)) this.cards.delete(name);
    const shown = elements.length > 0 ? elements : [this.none];
    if (shown.length !== this.element.children.length || shown.some((e, k) => e !== this.element.children[k])) {
      this.element.replaceChildren(...shown);
    }
  }
}
