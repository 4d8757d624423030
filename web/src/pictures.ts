// Pictures of the largest fills: one WebGL context draws them all, each into a canvas of its own, so that they print.
import {
  AmbientLight, type BufferGeometry, Color, DirectionalLight, DoubleSide, Group, Mesh, MeshLambertMaterial, PerspectiveCamera, Scene,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { type Crop, readCrop, type Role } from './crop';
import type { Hole, Picture, Report } from './data';
import { el, number } from './dom';
import { levelText, squareMetres } from './holes';

const WIDTH = 560, HEIGHT = 380;
type Mode = 'before' | 'after' | 'marked';
const MARK = 0xd01c8b; // unlike water, plants, roofs and streets
const SHADE = 0x404040;
export const MARK_NAME = 'magenta';
const ELEVATION = 70, STRAIGHT_DOWN = 89.99; // degrees. Lower views hide the streets between houses

export function makeRenderer(): WebGLRenderer | null {
  try {
    const renderer = new WebGLRenderer({ antialias: true, alpha: true });
    renderer.setPixelRatio(1);
    renderer.setSize(2 * WIDTH, 2 * HEIGHT, false);
    return renderer;
  } catch {
    return null;
  }
}

const hasTexture = (crop: Crop): boolean => crop.parts.some((part) => part.texture !== null);

class View {
  private readonly scene = new Scene();
  private readonly camera: PerspectiveCamera;
  private readonly meshes: { role: Role; mesh: Mesh<BufferGeometry, MeshLambertMaterial> }[];

  constructor(private readonly renderer: WebGLRenderer, private readonly crop: Crop) {
    this.camera = new PerspectiveCamera(38, WIDTH / HEIGHT, crop.radius / 50, crop.radius * 60);
    this.meshes = crop.parts.map(({ role, geometry, texture }) => ({ role, mesh: new Mesh(geometry, new MeshLambertMaterial({
      vertexColors: geometry.hasAttribute('color'), side: DoubleSide, flatShading: true, ...(texture ? { map: texture } : {}) })) }));
    const isTextured = hasTexture(crop), sun = new DirectionalLight(0xffffff, isTextured ? 1.0 : 1.9);
    sun.position.set(-0.6, -0.5, 1);
    this.scene.add(new AmbientLight(0xffffff, isTextured ? 2.4 : 1.5), sun, new Group().add(...this.meshes.map(({ mesh }) => mesh)));
  }

  private controls: OrbitControls | null = null;

  orbit(canvas: HTMLCanvasElement, draw: () => void): void {
    const controls = this.controls = new OrbitControls(this.camera, canvas);
    controls.enableZoom = false; // the wheel scrolls the page, unless the picture has the focus
    canvas.addEventListener('focus', () => { controls.enableZoom = true; });
    canvas.addEventListener('blur', () => { controls.enableZoom = false; });
    canvas.addEventListener('pointerdown', () => canvas.focus());
    controls.addEventListener('change', draw);
    this.lookFrom(ELEVATION);
  }

  // So that north is up.
  lookFromAbove(): void {
    this.lookFrom(STRAIGHT_DOWN);
  }

  // From the south, at so many degrees above the horizon.
  private lookFrom(elevation: number): void {
    const [x, y, z] = this.crop.centre, distance = 3.3 * this.crop.radius, angle = elevation * Math.PI / 180;
    this.camera.up.set(0, 0, 1);
    this.camera.position.set(x, y - distance * Math.cos(angle), z + distance * Math.sin(angle));
    this.controls?.target.set(x, y, z);
    this.controls?.update();
  }

  // What the renderer and the page keep of it.
  dispose(): void {
    this.controls?.dispose();
    for (const { mesh } of this.meshes) {
      mesh.geometry.dispose();
      mesh.material.map?.dispose();
      mesh.material.dispose();
    }
    this.renderer.renderLists.dispose();
  }

  draw(canvas: HTMLCanvasElement, mode: Mode): void {
    for (const { role, mesh } of this.meshes) {
      mesh.visible = role === 'kept' || (role === 'cleared') === (mode === 'before');
      if (role !== 'added') continue;
      const isMarked = mode === 'marked';
      mesh.material.emissive = new Color(isMarked ? MARK : 0);
      mesh.material.color = new Color(isMarked ? SHADE : 0xffffff); // else image and light wash the mark out
    }
    this.renderer.render(this.scene, this.camera);
    const pen = canvas.getContext('2d');
    if (!pen) return;
    pen.clearRect(0, 0, canvas.width, canvas.height);
    pen.drawImage(this.renderer.domElement, 0, 0, canvas.width, canvas.height);
  }
}

const MOST_NAMED = 12; // holes of a cluster

// " of a cluster with holes 3, 5": the other fills that are decided on with it. The picture may show them or not.
function clusterText(hole: Hole, holes: Hole[]): string {
  const cluster = hole.cluster ?? -1;
  const others = cluster < 0 ? [] : holes.filter((h) => h.filled && h.cluster === cluster && h.id !== hole.id).map(({ id }) => id);
  if (others.length === 0) return '';
  const more = others.length > MOST_NAMED ? ` and ${number(others.length - MOST_NAMED)} more` : '';
  return ` of a cluster with ${others.length === 1 ? 'hole' : 'holes'} ${others.slice(0, MOST_NAMED).join(', ')}${more}`;
}

function captionOf(hole: Hole | undefined, picture: Picture, holes: Hole[]): string {
  if (!hole) return `hole ${picture.hole}`;
  const level = levelText(hole.level);
  const sigma = hole.sigma === null || hole.sigma === undefined ? '' : `, sigma ${number(hole.sigma, 3)} m`;
  return `hole ${hole.id}${clusterText(hole, holes)}, cell ${hole.cell.join(', ')}, ${squareMetres(hole)}, ${hole.method}` +
    (level ? ` at ${level} m${sigma}` : '');
}

function canvasOf(className: string): HTMLCanvasElement {
  const canvas = el('canvas', { class: className, tabindex: '0' });
  canvas.width = 2 * WIDTH;
  canvas.height = 2 * HEIGHT;
  return canvas;
}

export class Card {
  readonly element: HTMLElement;
  private readonly canvas = canvasOf('view');
  private readonly printed = canvasOf('view print'); // the state before, beside the state after, on paper
  private readonly buttons = new Map<Mode, HTMLButtonElement>();
  private readonly note = el('p', { class: 'quiet' }, 'loading');
  private mode: Mode = 'after';
  private view: View | null = null;
  private isOver = false;

  // `remark` is shown below the picture.
  constructor(private readonly read: () => Promise<Crop>, caption: string, private readonly remark: string) {
    const bar = el('div', { class: 'modes' });
    for (const mode of ['before', 'after', 'marked'] as Mode[]) {
      const button = el('button', { type: 'button', click: () => this.show(mode) }, mode);
      this.buttons.set(mode, button);
      bar.append(button);
    }
    bar.append(el('button', { type: 'button', class: 'above', click: () => this.view?.lookFromAbove() }, 'from above'));
    this.canvas.setAttribute('role', 'img');
    this.canvas.setAttribute('aria-label', caption);
    this.printed.setAttribute('aria-hidden', 'true');
    this.printed.tabIndex = -1;
    this.element = el('figure', { class: 'card' }, el('div', { class: 'views' }, this.printed, this.canvas),
      el('figcaption', {}, el('span', {}, caption), bar), this.note);
    this.show('after');
  }

  async load(renderer: WebGLRenderer): Promise<void> {
    try {
      const crop = await this.read();
      if (this.isOver) return;
      this.view = new View(renderer, crop);
      this.view.orbit(this.canvas, () => this.draw());
      this.show(hasTexture(crop) ? 'after' : 'marked'); // without texture a fill looks like its surroundings
      this.view.draw(this.printed, 'before');
      this.note.textContent = [this.remark, crop.remark].filter(Boolean).join(' ');
      this.element.dataset['loaded'] = 'yes';
    } catch (error) {
      this.note.textContent = `This picture cannot be shown: ${error instanceof Error ? error.message : String(error)}`;
    }
  }

  // Once it is not shown any more.
  dispose(): void {
    this.isOver = true;
    this.view?.dispose();
    this.view = null;
  }

  private show(mode: Mode): void {
    this.mode = mode;
    for (const [name, button] of this.buttons) button.setAttribute('aria-pressed', String(name === mode));
    this.draw();
  }

  private draw(): void {
    this.view?.draw(this.canvas, this.mode);
  }
}

// The id of the element with the picture of a hole.
export const pictureId = (hole: number): string => `picture-${hole}`;

export function pictures(report: Report): HTMLElement {
  const box = el('div', { class: 'cards' });
  const holes = new Map(report.per_hole.map((hole) => [hole.id, hole]));
  const renderer = report.pictures.length > 0 ? makeRenderer() : null;
  if (report.pictures.length > 0 && !renderer) return el('p', {}, 'This browser has no WebGL, so there are no pictures.');
  const cards = report.pictures.map((picture) => new Card(() => readCrop(picture.bytes),
    captionOf(holes.get(picture.hole), picture, report.per_hole), picture.coarser ? 'Small triangles are left out of this picture.' : ''));
  cards.forEach((card, i) => { card.element.id = pictureId(report.pictures[i]!.hole); });
  box.append(...cards.map((card) => card.element));
  const loadAll = async () => {
    for (const card of cards) {
      if (renderer) await card.load(renderer);
    }
    document.body.dataset['pictures'] = 'ready';
  };
  void loadAll();
  return box;
}
