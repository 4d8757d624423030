// How far a running job is, how fast it goes, and when it will be over.
import type { Job } from './api';
import { number } from './dom';

// As DurationText in client/output.cc.
export function durationText(exact: number): string {
  if (!Number.isFinite(exact)) return '';
  if (exact < 0.5) return 'less than 1 s';
  const seconds = Math.round(exact), part = (unit: number, base: number) => String(Math.floor(seconds / unit) % base).padStart(2, '0');
  if (seconds < 60) return `${seconds} s`;
  if (seconds < 3600) return `${Math.floor(seconds / 60)} min ${part(1, 60)} s`;
  if (seconds < 48 * 3600) return `${Math.floor(seconds / 3600)} h ${part(60, 60)} min`;
  return `${Math.floor(seconds / 86400)} d ${part(3600, 24)} h`;
}

const MOST_TASKS_OUT = 8192; // kMostTasksOut of coordinator/jobs/job_pipeline.h

// As ShareDone in coordinator/jobs/cluster_events.cc, by one table of tests: 0 to 1. Tasks of later stages are not among `tasks` yet.
export function shareDone({ progress }: Job): number {
  const cells = Number(progress.cells), tasks = Number(progress.tasks), done = Number(progress.tasksDone);
  if (cells === 0) return 0;
  const out = tasks - done, areHeldBack = out > MOST_TASKS_OUT / 2;
  let toCome = cells;
  if (progress.phase === 'survey' || progress.phase === 'plan') toCome = 2 * cells + (areHeldBack ? Math.max(0, cells - tasks) : 0);
  if (progress.phase === 'assemble') toCome = areHeldBack ? Math.max(0, cells - Number(progress.cellsDone) - out) : 0;
  if (progress.phase === 'verify') toCome = 0;
  return Math.min(1, done / Math.max(1, tasks + toCome));
}

interface Sample { time: number; share: number; tasks: number; cells: number }

const WINDOW = 60_000, LEAST_WINDOW = 10_000; // milliseconds
const LEAST_SHARE = 0.05; // as TimesText in client/progress_display.cc: too little to guess by

// Over the last minute that was seen, else since the first task was given to a worker.
export class Rates {
  private readonly seen = new Map<string, Sample[]>();

  add(job: Job, now: number): void {
    const list = this.seen.get(job.name) ?? [];
    list.push({ time: now, share: shareDone(job), tasks: Number(job.progress.tasksDone), cells: Number(job.progress.cellsDone) });
    while (list.length > 2 && now - list[0]!.time > WINDOW) list.shift();
    this.seen.set(job.name, list);
  }

  // "3.2 tasks/s, 1 min 10 s left"; cells in place of tasks once they are written; "" while nothing is done.
  textOf(job: Job, now: number): string {
    const last = { time: now, share: shareDone(job), tasks: Number(job.progress.tasksDone), cells: Number(job.progress.cellsDone) };
    const begin = { time: Date.parse(job.startTime ?? job.createTime), share: 0, tasks: 0, cells: 0 };
    const seen = this.seen.get(job.name)?.[0];
    const first = seen && last.time - seen.time > LEAST_WINDOW && last.share > seen.share ? seen : begin;
    const seconds = Math.max(0.001, (last.time - first.time) / 1000);
    const cells = (last.cells - first.cells) / seconds, tasks = (last.tasks - first.tasks) / seconds;
    const speed = first !== begin && cells > 0 ? perTime(cells, 'cells') : tasks > 0 ? perTime(tasks, 'tasks') : '';
    const share = (last.share - first.share) / seconds;
    const left = last.share > LEAST_SHARE && last.share < 1 && share > 0 ? `${durationText((1 - last.share) / share)} left` : '';
    return [speed, left].filter(Boolean).join(', ');
  }
}

function perTime(rate: number, what: string): string {
  return rate >= 1 ? `${number(rate, 1)} ${what}/s` : `${number(60 * rate, 1)} ${what}/min`;
}
