// The review queue on the page of a job: offered, shown, and closed when the report is another one.
import { ApiError, get, type Holes, type JobReview, type Me } from './api';
import { coordinatorAt, decisionsCommand } from './command';
import type { Hole } from './data';
import { counted, el } from './dom';
import { type PictureLink, type ReviewQueue, reviewQueue } from './review';

const READ_AGAIN = 500; // milliseconds, at least, until a queue that is being read is asked for again

// What an error says, with a link to the job that has written the output since, if the coordinator knows it.
export function errorWithLink(error: ApiError): (Node | string)[] {
  const later = error.metadata['job'];
  return later ? [`${error.message}. `, el('a', { href: `#jobs/${later}` }, `Show jobs/${later}.`)] : [error.message];
}

export class JobReviewBox {
  readonly element = el('div', {});
  private queue: ReviewQueue | null = null;      // null: it is not shown
  private shownOf: JobReview | null = null;      // what the queue was made of
  private holes: Holes | null = null;
  private isStale = false;                       // the holes have changed since
  private offered = '';

  constructor(private readonly name: string, private readonly pictureOf: (hole: number) => PictureLink | null) {}

  canDecide(hole: Hole): boolean { return this.queue?.canDecide(hole) ?? true; }

  // `gone`: why there are no holes any more. Throws what a poll throws.
  async update(holes: Holes | null, gone: ApiError | null): Promise<void> {
    if (this.queue && holes !== this.holes) this.isStale = true;
    this.holes = holes;
    if (!this.queue) this.offer(holes);
    else if (!holes) this.close(gone);
    else if (this.isStale) await this.readAgain();
  }

  // The queue of the report, with the row of the hole in focus.
  async show(hole: Hole | null): Promise<void> {
    try {
      if (!this.queue) await this.read();
    } catch (error) {
      if (error instanceof ApiError && error.status === 503) {
        this.say('quiet', 'The review queue is being read.');
        setTimeout(() => { if (this.element.isConnected) void this.show(hole); }, Math.max(READ_AGAIN, error.wait));
        return;
      }
      this.say('warning', 'The review queue cannot be shown: ', ...(error instanceof ApiError ? errorWithLink(error) : [(error as Error).message]));
      return;
    }
    if (hole) this.queue?.decide(hole);
    else this.element.scrollIntoView({ block: 'start' });
  }

  // A line that opens the queue, which may be large.
  private offer(holes: Holes | null): void {
    const known = holes && !holes.planned ? holes.holes : [], toDecide = holes?.fillsToDecide ?? 0;
    const decided = known.filter((hole) => hole.decision).length;
    const told = [toDecide > 0 ? `${counted(toDecide, 'fill')} to decide on` : '', decided > 0 ? `${counted(decided, 'hole')} decided on` : ''];
    const text = told.filter(Boolean).join(', ');
    if (text === this.offered) return;
    this.offered = text;
    this.element.replaceChildren(...(text ? [el('h2', {}, 'Review'), el('p', { class: 'offer' }, `${text} `,
      el('button', { type: 'button', click: () => void this.show(null) }, 'show the review queue'))] : []));
  }

  private say(kind: string, ...text: (Node | string)[]): void {
    this.element.replaceChildren(el('h2', {}, 'Review'), el('p', { class: kind, role: 'status' }, ...text));
  }

  private close(gone: ApiError | null): void {
    this.queue = this.shownOf = null;
    this.offered = '';
    this.say('warning', 'The review queue was closed: ', ...(gone ? errorWithLink(gone) : ['its report is gone.']));
  }

  // The queue of a report that was written again, in place of that of the report before. If it is being read, the next
  // poll asks again.
  private async readAgain(): Promise<void> {
    const before = this.shownOf;
    try {
      await this.read();
    } catch (error) {
      if (!(error instanceof ApiError) || error.status === 0 || error.status === 401) throw error;
      if (error.status !== 503) this.close(error);
      return;
    }
    if (this.shownOf !== before) this.element.prepend(el('p', { class: 'warning', role: 'status' }, 'The report was written again. This is its review queue.'));
  }

  private async read(): Promise<void> {
    const found = await get<JobReview>(`/v1/${this.name}/review`);
    this.isStale = false;
    if (found === this.shownOf) return;
    const { review, ...report } = found;
    const { listen } = await get<Me>('/v1/me'), at = coordinatorAt(listen ?? '', location.hostname);
    this.queue = reviewQueue(report, review, this.holes?.holes ?? [], decisionsCommand(report, 'submit', at),
      { addHint: 'To add any other fill, choose it in the table of holes, then \u201cdecide on it in the review queue\u201d beside the map.',
        commandHint: 'FILE is the path of the downloaded file in a folder that coordinator and workers may read (--root).',
        pictureOf: this.pictureOf });
    this.shownOf = found;
    this.element.replaceChildren(el('h2', {}, 'Review'), this.queue.element);
  }
}
