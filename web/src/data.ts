// The facts of a report, as client/page_data.h writes them into the page.

export type Level = number | [number, number] | null;

export interface Hole {
  id: number;
  cell: [number, number];
  centre: number[];
  kind: string;
  area: number | null; // null: not known
  rim: number | null;
  filled: boolean;
  counts: boolean;     // it is left open, and that makes the output partial
  method: string;
  level: Level;
  sigma: number | null;
  doubt: number | null; // m3
  crossings: number | null; // triangles of the patch that cross others
  cluster: number | null;   // holes of one are decided on together; -1 or null: of none
  decision: string;
  reason: string;
  taken_for?: string;        // of holes that were judged: what the hole was taken for,
  rim_level?: number | null; // and the level of its rim, if it tells one
  planned?: boolean;    // it is not known yet what becomes of it
}

export interface Water {
  body: number;
  kind: string;
  level_m: Level;
  sigma_m: number | null;
  area_m2: number;
  cells: number;
  decided_by: string;
}

export interface LookAt {
  hole?: number;
  holes?: number[]; // all that `area_m2` is of; `hole` is the largest
  cell?: [number, number];
  centre?: number[];
  area_m2?: number;
  why?: string;
}

// All holes that a row is about. Rows about one cluster may be named by different holes of it.
export function holesOf({ hole, holes }: { hole?: number; holes?: number[] }): number[] {
  return [...new Set([...hole === undefined ? [] : [hole], ...holes ?? []])];
}

// Holes that are decided on together, and what they were taken for.
export interface ReviewItem {
  hole: number;
  holes: number[];
  cell: [number, number];
  area_m2: number;
  taken_for: string;
  level_m?: number;
  sigma_m?: number;
  reason: string;
  doubt_m: number | null; // null: not known
  doubt_m3: number | null;
  crossings?: number;
}

export interface Review {
  count: number; // of all in doubt, which may be more than the items
  items: ReviewItem[];
  z: number | null; // the height of the levels' zero
  crs: unknown;
  scene?: unknown;  // that the outlines are of, for the file
  outlines: string; // gzip, as base64: by hole of the item its Outlines
  others: string;   // the same: by hole the Outline of each other hole with a fill, the largest fills first
  without_outline?: number[]; // holes with a fill that have none here, nor has any of their cluster
  decided?: number; // count of `earlier`
  earlier: string;  // the same: the features of decisions that were made before
}

// The polygon of one of the holes of an item.
export interface Outline { hole: number; cluster: number | null; geometry: unknown }

// Of one level of detail: nodes, and triangles added and removed.
export interface DetailLevel {
  level: number;
  nodes: number;
  filled: number;
  added: number;
  removed: number;
}

export interface Picture {
  hole: number;
  triangles: number;
  coarser: boolean;
  bytes: string; // gzip, as base64
}

// [column, row, holes filled, holes left, 1 if the cell has a tile, those of the left that make the output partial]
export type Cell = [number, number, number, number, number, number];

// Of the holes in the cells that were chosen: `counting` of those left make the output partial, `uncounted` says why the
// others do not, `chosen` how many cells were, if not all.
export interface Verdict { filled: number; left: number; counting: number; uncounted: string; chosen: string }

// What `tilemend check` found, if it was asked to say so on the page: of each fault the first places.
export interface FaultPlace { cell?: [number, number]; at?: [number, number, number]; hole?: number; note?: string }
export interface Fault { what: string; count: number; places: FaultPlace[] }
export interface Acceptance { accepted: boolean; verdict: string; date: string | null; faults: Fault[] }

export interface Report {
  version: string | null;
  date: string | null;
  scene: string | null;
  out?: string;        // the folder that the page was made in
  options: Record<string, unknown> | null;
  changed_options?: Record<string, unknown>; // those that are not the defaults
  warnings: string[] | null;
  water: Water[] | null;
  look_at: LookAt[] | null;
  cleared: { triangles?: number } | null;
  levels: DetailLevel[] | null;
  cells: Cell[];
  verdict: Verdict;
  acceptance?: Acceptance | null;
  grid: { crs: string; cell_size: [number, number]; corner: [number, number] } | null;
  hole_count: number;
  per_hole: Hole[];
  pictures: Picture[];
  picture_problems: string[];
  review: Review | null;
  tasks: { tiles: number; tiles_kept: number } | null;
}

export function readReport(): Report {
  return JSON.parse(document.getElementById('data')?.textContent ?? '{}') as Report;
}
