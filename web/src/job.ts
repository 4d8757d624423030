// One job: its map as it goes, its holes, its failures, its review queue, and its cells before and after.
import type { WebGLRenderer } from 'three';
import { ApiError, type Cells, get, type Holes, type Job, type LogLines } from './api';
import type { Hole } from './data';
import { el } from './dom';
import { Failures } from './failures';
import { type Grid, legendOf, makeGrid } from './grid';
import { type HoleRows, holesTable, type HolesTable, squareMetres } from './holes';
import { JobMap, STATE_NAMES } from './job_map';
import { errorWithLink, JobReviewBox } from './job_review';
import { isOver } from './jobs';
import { Card, makeRenderer, MARK_NAME } from './pictures';
import type { PictureLink } from './review';
import { readCell } from './tile';
import { warningList } from './warnings';

const AGAIN = 30_000; // milliseconds until what a job that is over does not have is asked for again

let renderer: WebGLRenderer | null | undefined;

// The rows of the table. While a job runs the plan's holes are shown, filled where their cells are.
function rowsOf(holes: Holes, map: JobMap): HoleRows {
  const rows = !holes.planned ? holes.holes : holes.holes.map((hole) => {
    const filled = hole.filled && map.isFilled(hole.cell);
    return { ...hole, filled, planned: hole.filled && !filled };
  });
  return { per_hole: rows, hole_count: holes.holeCount };
}

const NO_CELLS: Cells = {
  state: '', column: 0, row: 0, columns: 0, rows: 0, hasTiles: false, isRemembered: true, cells: '', held: [], failures: [] };

// Whether no task of a job that is over failed for good.
const endedWell = ({ state, progress }: Job): boolean =>
  state === 'DONE' || (state === 'PARTIAL' && Number(progress.tasksQuarantined) === 0);

export class JobView {
  readonly element = el('section', { class: 'jobview' });
  private readonly mapBox = el('div', { class: 'mapbox' });
  private readonly detail = el('div', { class: 'detail' });
  private readonly failures = new Failures((cell) => this.chooseCell(cell));
  private readonly warnings = el('div', {});
  private readonly holesNote = el('p', { class: 'quiet' });
  private readonly holesBox = el('div', {});
  private readonly review: JobReviewBox;
  private grid: Grid | null = null;
  private card: Card | null = null;
  private mapNote = '';
  private holesError = '';
  private gone: ApiError | null = null; // why there are no holes any more
  private holesNext = 0;   // when to ask for them again
  private shape = '';
  private map: JobMap | null = null;
  private holes: Holes | null = null;
  private told = '';
  private toldWarnings = '[]';
  private lines: LogLines = { lines: [] };
  private table: HolesTable | null = null;
  private shown: [[number, number], Hole | null] | null = null; // what the detail is of

  constructor(private readonly name: string) {
    this.review = new JobReviewBox(name, (hole) => this.pictureOf(hole));
    this.element.append(el('h2', {}, `Map of ${name}`), this.warnings, el('div', { class: 'mapanddetail' }, this.mapBox, this.detail),
      this.failures.element, this.review.element, this.holesBox);
  }

  async poll(job: Job): Promise<void> {
    const cells = await this.readCells(job);
    if (!cells) return;
    const isPlanned = Number(job.progress.holes) > 0 || (isOver(job) && job.report !== '');
    const holes = isPlanned ? await this.readHoles(job) : null;
    const lines = await get<LogLines>(`/v1/${this.name}/log`);
    this.drawWarnings([...new Set([...job.warnings, ...holes?.warnings ?? []])]);
    const told = this.mapNote + this.holesError;
    const isSame = cells === this.map?.cells && holes === this.holes && lines === this.lines && told === this.told;
    this.told = told;
    this.holes = holes;
    this.lines = lines;
    if (!isSame) this.drawAll(job, cells);
    await this.review.update(holes, this.gone);
  }

  private drawAll(job: Job, cells: Cells): void {
    const hadTiles = this.map?.cells.hasTiles ?? false;
    this.map = new JobMap(cells, this.holes);
    this.draw(this.map);
    if (cells.hasTiles && !hadTiles && this.shown) this.showDetail(...this.shown);
    this.failures.update(cells, this.lines.lines);
    this.drawHoles(job, this.map);
  }

  // Those of the job, then those of its report. A list that was opened stays open while nothing changes.
  private drawWarnings(texts: string[]): void {
    const told = JSON.stringify(texts);
    if (told === this.toldWarnings) return;
    this.toldWarnings = told;
    this.warnings.replaceChildren(...(texts.length > 0 ? [warningList(texts)] : []));
  }

  // Chooses a cell as a click on it does.
  chooseCell(cell: [number, number]): void {
    const k = this.map?.indexOf(cell) ?? -1;
    if (!this.map?.stateOf(k)) return;
    this.grid?.select(k);
    this.table?.showCell(cell);
    this.showDetail(cell, null);
  }

  dispose(): void {
    this.card?.dispose();
    this.grid?.dispose();
  }

  // As before while its scene is read, null at first. A map without cells if it is too large.
  private async readCells(job: Job): Promise<Cells | null> {
    try {
      const cells = await get<Cells>(`/v1/${this.name}/cells`);
      this.mapNote = cells.isRemembered || endedWell(job) ? '' : 'This job was over before the coordinator was last started. Which of its tasks failed is not known.';
      return cells;
    } catch (error) {
      if (!(error instanceof ApiError) || (error.status !== 503 && error.status !== 409 && error.reason !== 'TOO_LARGE')) throw error;
      if (error.status === 503) return this.map?.cells ?? null;
      this.mapNote = error.message;
      return NO_CELLS;
    }
  }

  // As before while they are read; null if there are none.
  private async readHoles(job: Job): Promise<Holes | null> {
    const now = Date.now();
    if (now < this.holesNext) return this.holes;
    this.holesError = '';
    this.gone = null;
    try {
      return await get<Holes>(`/v1/${this.name}/holes`);
    } catch (error) {
      if (!(error instanceof ApiError) || error.status === 0 || error.status === 401) throw error;
      if (error.status === 503) {
        if (!this.holes) this.holesError = 'The list of holes is being read.';
        this.holesNext = now + error.wait;
        return this.holes;
      }
      if (isOver(job)) this.holesNext = now + AGAIN;
      // 404: none yet, or its folder is gone. 409: a later job has written there.
      if (error.status !== 404) this.holesError = `The list of holes cannot be shown: ${error.message}`;
      if (error.status !== 404 && error.status !== 409) return this.holes;
      this.gone = error;
      return null;
    }
  }

  private draw(map: JobMap): void {
    const shape = JSON.stringify([map.frame, map.cells.cellSize, map.cells.hasTiles]), legend = legendOf(STATE_NAMES, map.states());
    if (map.frame.columns === 0) {
      this.grid?.dispose();
      this.grid = null;
      this.mapBox.replaceChildren(el('p', { class: 'quiet' }, this.mapNote || 'The cells are not known yet.'));
      return;
    }
    if (this.grid && shape === this.shape) {
      this.grid.update(map);
      this.mapBox.lastElementChild?.replaceWith(legend);
      return;
    }
    this.shape = shape;
    this.grid?.dispose();
    this.grid = makeGrid(map, { choose: (k) => { if (this.map) this.chooseCell(this.map.cellOf(k)); }, cellSize: map.cells.cellSize ?? [1, 1] });
    this.mapBox.replaceChildren(el('p', { class: 'quiet' }, this.mapNote), this.grid.element, legend);
    if (this.detail.childElementCount === 0) {
      this.detail.append(el('p', { class: 'quiet' }, 'Choose a cell of the map or a hole of the table to see more of it.'));
    }
  }

  private chooseHole(hole: Hole): void {
    this.grid?.select(this.map?.indexOf(hole.cell) ?? -1);
    this.showDetail(hole.cell, hole);
    this.detail.scrollIntoView({ behavior: 'smooth', block: 'nearest' });
  }

  private showDetail(cell: [number, number], hole: Hole | null): void {
    const map = this.map;
    if (!map) return;
    this.shown = [cell, hole];
    const text = hole ? `Hole ${hole.id}, ${squareMetres(hole)}, in cell ${cell.join(', ')}` : map.textOf(map.indexOf(cell));
    const parts: HTMLElement[] = [el('p', { role: 'status' }, text)];
    if (map.cells.hasTiles) {
      const button = el('button', { type: 'button', class: 'topicture', click: () => this.showPicture(cell, hole, button) }, 'show before and after');
      parts.push(button);
    }
    if (hole?.filled && !this.holes?.planned && this.review.canDecide(hole) || hole?.decision) {
      parts.push(el('button', { type: 'button', class: 'toreview', click: () => void this.review.show(hole.decision ? null : hole) }, hole.decision ? 'see the decisions' : 'decide on it in the review queue'));
    }
    this.card?.dispose();
    this.card = null;
    this.detail.replaceChildren(...parts);
  }

  private showPicture(cell: [number, number], hole: Hole | null, button: HTMLElement): void {
    renderer ??= makeRenderer();
    if (!renderer) {
      button.replaceWith(el('p', {}, 'This browser has no WebGL, so there are no pictures.'));
      return;
    }
    const card = this.card = new Card(() => readCell(this.name, cell, hole), hole ? `hole ${hole.id} in cell ${cell.join(', ')}` : `cell ${cell.join(', ')}`,
      `Drag to turn, click and use the wheel to zoom. \u201cMarked\u201d shows new surface in ${MARK_NAME}.`);
    button.replaceWith(card.element);
    void card.load(renderer);
  }

  private drawHoles(job: Job, map: JobMap): void {
    const { holes } = this;
    if (!holes) {
      this.table = null;
      const none = isOver(job) ? 'There is no list of holes.' : 'The holes are listed here once all cells are surveyed and the plan is made.';
      const why = this.gone && this.holesError ? ['The list of holes cannot be shown: ', ...errorWithLink(this.gone)] : [this.holesError || none];
      this.holesBox.replaceChildren(el('h2', {}, 'Holes'), el('p', { class: 'quiet' }, ...why));
      return;
    }
    this.holesNote.textContent = this.holesError ? this.holesError : holes.planned
      ? 'As planned. A hole counts as filled here when its cell is; the report has the last word, and the methods.' : '';
    if (this.table) return this.table.update(rowsOf(holes, map));
    this.table = holesTable(rowsOf(holes, map), (hole) => this.chooseHole(hole));
    this.holesBox.replaceChildren(el('h2', {}, 'Holes'), this.holesNote, this.table.element);
  }

  private pictureOf(id: number): PictureLink | null {
    const hole = this.holes?.holes.find((h) => h.id === id);
    if (!hole || !this.map?.cells.hasTiles) return null;
    return { href: `#${this.name}`, show: () => {
      this.chooseHole(hole);
      this.detail.querySelector<HTMLButtonElement>('.topicture')?.click();
    } };
  }
}
