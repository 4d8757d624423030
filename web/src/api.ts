// The JSON mirror of the coordinator (/v1/openapi.json).
import type { Hole, LookAt, Review } from './data';

export interface Progress {
  phase: string; cells: string; cellsDone: string; holes: string; holesFilled: string;
  tasks: string; tasksDone: string; tasksRunning: string; tasksRetried: string; tasksQuarantined: string;
}

export type JobState = 'RUNNING' | 'DONE' | 'PARTIAL' | 'FAILED' | 'CANCELLED';

export interface Job {
  name: string; state: JobState; spec: { scene: string; out: string }; progress: Progress;
  createTime: string; startTime?: string; endTime?: string; error?: { message: string }; message: string; report: string;
  warnings: string[]; owner: string; trace: string; waiting: string; priority: number; paused: boolean;
}

export interface WorkerTask { job: string; stage: string; col: number; row: number; since: string }

export interface WorkerInfo {
  id: string; state: string; threads: number; tasks: number; firstSeen: string; lastSeen: string; release: string;
  identity: string; message: string; doing: WorkerTask[];
}

export interface Failure { cell: [number, number]; stage: string; reason: string }

export interface Cells {
  state: string; column: number; row: number; columns: number; rows: number; cellSize?: [number, number];
  hasTiles: boolean; isRemembered: boolean; cells: string; held: [number, number][]; failures: Failure[];
}

export interface Holes { holeCount: number; holes: Hole[]; planned: boolean; date?: string | null; warnings?: string[]; fillsToDecide?: number }

export interface JobReview {
  scene: string | null; out?: string; date: string | null; changed_options?: Record<string, unknown>; look_at: LookAt[] | null; review: Review;
}

export interface LogLines { lines: string[] }

export interface Me { name: string; maySteer: boolean; isAdmin: boolean; listen?: string }

// `status` 0: the coordinator did not answer. `wait`: milliseconds until it wants to be asked again, if it says so.
// `metadata`: facts that belong to the reason.
export class ApiError extends Error {
  constructor(readonly status: number, message: string, readonly reason: string, readonly wait = 0,
    readonly metadata: Record<string, string> = {}) { super(message); }
}

const TOKEN = 'tilemend-token';
const MOST_KNOWN = 64;             // answers that are kept
const PATIENCE = 30_000;           // milliseconds that an answer to a poll may take
const known = new Map<string, { tag: string; value: unknown }>();

export const hasToken = (): boolean => sessionStorage.getItem(TOKEN) !== null;

// Headers have no other letters.
export const isToken = (text: string): boolean => /^[!-~]+$/.test(text);

export function setToken(token: string): void {
  known.clear();
  if (token) sessionStorage.setItem(TOKEN, token);
  else sessionStorage.removeItem(TOKEN);
}

async function call(method: string, path: string, headers: Record<string, string>, more: RequestInit = {}): Promise<Response> {
  const token = sessionStorage.getItem(TOKEN);
  if (token) headers['Authorization'] = `Bearer ${token}`;
  let answer: Response;
  try {
    answer = await fetch(path, { method, headers, cache: 'no-store', ...more });
  } catch {
    throw new ApiError(0, 'the coordinator does not answer', '');
  }
  if (answer.ok || answer.status === 304) return answer;
  const { error } = await answer.json().catch(() => ({})) as { error?: { message: string; reason: string; metadata?: Record<string, string> } };
  throw new ApiError(answer.status, error?.message ?? answer.statusText, error?.reason ?? '', 1000 * (Number(answer.headers.get('Retry-After')) || 0), error?.metadata);
}

// The same object as before if nothing has changed.
export async function get<T>(path: string): Promise<T> {
  const before = known.get(path);
  const answer = await call('GET', path, before ? { 'If-None-Match': before.tag } : {}, { signal: AbortSignal.timeout(PATIENCE) });
  const isSame = answer.status === 304 && before;
  const now = isSame ? before : { tag: answer.headers.get('ETag') ?? '', value: await answer.json() };
  known.delete(path);
  known.set(path, now); // the last asked for is the last
  for (const oldest of known.keys()) {
    if (known.size <= MOST_KNOWN) break;
    known.delete(oldest);
  }
  return now.value as T;
}

// All items of a list, which comes in pages, but at most about `most`. The first pages are those that change.
export async function getAll<T>(path: string, field: string, most: number): Promise<{ items: T[]; isAll: boolean }> {
  const items: T[] = [];
  let token = '';
  do {
    const page = await get<Record<string, T[]> & { nextPageToken: string }>(`${path}${token ? `&pageToken=${encodeURIComponent(token)}` : ''}`);
    items.push(...page[field] ?? []);
    token = page.nextPageToken;
  } while (token && items.length < most);
  return { items, isAll: !token };
}

// The tile of a cell, `path` being /v1/jobs/JOB/cells/CELL/before or after, or a file that the tile names.
export interface TileFile { format: string; frame: number[] | null; bytes: ArrayBuffer }

export async function getTile(path: string, file = ''): Promise<TileFile> {
  const answer = await whenThereIsRoom(() => call('GET', file ? `${path}?path=${encodeURIComponent(file)}` : path, {}));
  const frame = answer.headers.get('X-Tile-Frame');
  return { format: (answer.headers.get('X-Tile-Format') ?? '').toLowerCase(), bytes: await answer.arrayBuffer(),
    frame: frame ? frame.split(' ').map(Number) : null };
}

// The coordinator reads a few tiles at once; who comes then asks again.
async function whenThereIsRoom(ask: () => Promise<Response>): Promise<Response> {
  for (let wait = 250; ; wait *= 2) {
    let told = 0;
    try {
      return await ask();
    } catch (error) {
      if (!(error instanceof ApiError) || error.status !== 503 || wait > 8000) throw error;
      told = Math.min(error.wait, PATIENCE);
    }
    await new Promise((resolve) => { setTimeout(resolve, Math.max(wait, told)); });
  }
}

// Null if there is no such file.
export async function getTileIfThere(path: string, file = ''): Promise<TileFile | null> {
  try {
    return await getTile(path, file);
  } catch (error) {
    if (error instanceof ApiError && error.reason === 'TILE_NOT_FOUND') return null;
    throw error;
  }
}

export async function post(path: string, body: unknown): Promise<Job> {
  return await (await call('POST', path, { 'Content-Type': 'application/json' }, { body: JSON.stringify(body) })).json() as Job;
}
