// The facts of a report, as client/page_data.h writes them into the page.

export type Level = number | [number, number] | null;

export interface Hole {
  id: number;
  cell: [number, number];
  centre: number[];
  kind: string;
  area: number;
  rim: number | null;
  filled: boolean;
  method: string;
  level: Level;
  sigma: number | null;
  reason: string;
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
  cell?: [number, number];
  centre?: number[];
  area_m2?: number;
  why?: string;
}

export interface Picture {
  hole: number;
  triangles: number;
  coarser: boolean;
  bytes: string; // gzip, as base64
}

// [column, row, holes filled, holes left, 1 if the cell has a tile]
export type Cell = [number, number, number, number, number];

export interface Report {
  version: string | null;
  date: string | null;
  scene: string | null;
  options: Record<string, unknown> | null;
  warnings: string[] | null;
  water: Water[] | null;
  look_at: LookAt[] | null;
  cleared: { triangles?: number } | null;
  cells: Cell[];
  grid: { crs: string; cell_size: [number, number]; corner: [number, number] } | null;
  hole_count: number;
  per_hole: Hole[];
  pictures: Picture[];
  picture_problems: string[];
}

export function readReport(): Report {
  return JSON.parse(document.getElementById('data')?.textContent ?? '{}') as Report;
}
