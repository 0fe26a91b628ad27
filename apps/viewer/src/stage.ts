// The picture: objects, layers, axes and grid, drawn only when something changed.
import { Color, DirectionalLight, Group, HemisphereLight, Object3D, Plane, Raycaster, Scene, Vector2, Vector3, WebGLRenderer, Box3 } from 'three';
import { Orbit } from './camera';
import type { Theme } from './colours';
import { gridLines } from './grid';
import { discard } from './layers';
import { boxOfBodies, mostBoxes } from './moving';
import type { Objects } from './objects';
import type { PageData } from './data';

const patience = 250; // milliseconds of rest, after which all is drawn
const slow = 40; // milliseconds of a frame

export class Stage {
  readonly renderer: WebGLRenderer;
  readonly orbit: Orbit;
  drawn = 0; // frames, for tests
  isWhole = true; // all triangles are drawn, and not fewer while the picture moves
  private isSlow: boolean; // drawing all of them takes too long to be done while it moves
  private rest = 0; // the timer that waits for the picture to rest
  private readonly finest = Math.min(2, window.devicePixelRatio); // points of the screen for one of the page's
  private readonly scene = new Scene();
  private readonly overlays = new Group();
  private grid: Object3D | undefined;
  private waiting = false;
  private sized = false;
  private readonly sun = new DirectionalLight(0xffffff, 2.2);

  constructor(
    readonly canvas: HTMLCanvasElement,
    private readonly data: PageData,
    private readonly objects: Objects,
    private readonly afterDrawing: () => void,
  ) {
    // What are so many are a few points wide each: smooth edges would take a card that is a program most of its time.
    const most = Math.max(mostBoxes(data), data.report.objects?.length ?? 0);
    this.isSlow = objects.isHeavy; // until it is known
    this.renderer = new WebGLRenderer({ canvas, antialias: most < 10_000, stencil: true });
    this.renderer.setPixelRatio(this.finest);
    this.orbit = new Orbit(canvas, data.header.up, () => this.moved());
    if (this.isSlow) this.drawCoarse();
    this.scene.add(objects.group, this.overlays, this.orbit.camera, new HemisphereLight(0xffffff, 0x9098a4, 1.6));
    this.orbit.camera.add(this.sun, this.sun.target);
    this.sun.position.set(-0.4, 0.6, 1);
    this.sun.target.position.set(0, 0, 0);
    this.renderer.debug.checkShaderErrors = false; // to ask for them waits for the card
    objects.prepare(this.renderer, this.orbit.camera, this.scene);
    if (canvas.clientHeight > 0) this.orbit.resize(canvas.clientWidth, canvas.clientHeight); // what is framed has to fit
    new ResizeObserver(() => this.resize()).observe(canvas);
  }

  /// Asks for a frame while the picture moves: of fewer triangles and half as fine where all would take too long, until it rests.
  private moved(): void {
    if (this.isSlow) this.drawCoarse();
    this.redraw();
  }

  private drawCoarse(): void {
    if (this.isWhole) {
      this.objects.setDetail('coarse');
      this.renderer.setPixelRatio(this.finest / 2);
    }
    this.isWhole = false;
    window.clearTimeout(this.rest);
    this.rest = window.setTimeout(() => this.drawWhole(), patience);
  }

  private drawWhole(): void {
    if (this.drawn === 0) return this.drawCoarse(); // the first picture comes soon
    if (!this.isWhole) this.renderer.setPixelRatio(this.finest);
    this.objects.setDetail('whole');
    this.isWhole = true;
    const before = performance.now();
    this.drawNow();
    const { renderer } = this;
    const context = renderer.getContext();
    context.readPixels(0, 0, 1, 1, context.RGBA, context.UNSIGNED_BYTE, new Uint8Array(4)); // waits until it is drawn
    this.isSlow = performance.now() - before > slow;
  }

  /// Asks for a frame. However often it is asked, one is drawn.
  redraw(): void {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => this.drawNow());
  }

  /// With all triangles, now.
  drawAll(): void {
    if (!this.isWhole) this.drawWhole();
    else this.drawNow();
  }

  drawNow(): void {
    this.waiting = false;
    if (!this.sized) return; // `resize` comes, and draws
    this.renderer.render(this.scene, this.orbit.camera);
    ++this.drawn;
    this.afterDrawing();
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.canvas;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.sized = true;
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.orbit.resize(clientWidth, clientHeight);
    this.afterResizing();
    this.drawNow();
  }

  /// What is to be done once the picture has another size, before it is drawn.
  afterResizing = (): void => {};

  setOverlays(drawings: Object3D[]): void {
    for (const old of [...this.overlays.children]) discard(old);
    if (drawings.length > 0) this.overlays.add(...drawings);
    this.redraw();
  }

  private lit: Object3D | undefined;

  /// What lies under the pointer; nothing to put it out.
  setLit(drawn: Object3D | undefined): void {
    if (!drawn && !this.lit) return;
    if (this.lit) discard(this.lit);
    this.lit = drawn;
    if (drawn) this.scene.add(drawn);
    this.redraw();
  }

  /// Cuts away what is on the other side; without a plane nothing.
  setSection(plane: Plane | undefined): void {
    this.section = plane;
    this.renderer.clippingPlanes = plane ? [plane] : [];
    this.redraw();
  }

  private section: Plane | undefined;

  setTheme(theme: Theme, withGrid: boolean): void {
    this.scene.background = new Color(theme.background);
    if (this.grid) discard(this.grid);
    this.grid = withGrid ? gridLines(this.data.header, this.wholeBox(), theme) : undefined;
    if (this.grid) this.scene.add(this.grid);
    this.redraw();
  }

  wholeBox(): Box3 {
    const whole = new Box3();
    this.objects.boxes.forEach((box, i) => {
      if (this.data.report.objects[i].shape !== 'half-space') whole.union(box);
    });
    whole.union(boxOfBodies(this.data));
    if (whole.isEmpty()) for (const box of this.objects.boxes) whole.union(box);
    return whole.isEmpty() ? new Box3(new Vector3(-1, -1, -1), new Vector3(1, 1, 1)) : whole;
  }

  frameBox(box: Box3): void {
    const radius = box.getSize(new Vector3()).length() / 2;
    this.orbit.frame(box.getCenter(new Vector3()), radius > 0 ? radius : 1e-3);
  }

  /// What lies under a place of the page.
  hit(x: number, y: number): { object: number; point: Vector3 } | undefined {
    const hit = this.objects.hit(this.rayAt(x, y), (point) => !this.section || this.section.distanceToPoint(point) >= 0);
    if (!this.isWhole) this.objects.setDetail('coarse'); // rays meet all triangles
    return hit;
  }

  rayAt(x: number, y: number): Raycaster {
    const box = this.canvas.getBoundingClientRect();
    const at = new Vector2(((x - box.left) / box.width) * 2 - 1, 1 - ((y - box.top) / box.height) * 2);
    const ray = new Raycaster();
    ray.setFromCamera(at, this.orbit.camera);
    return ray;
  }

  /// Where a shown point is on the canvas, in its pixels; nothing when it is behind the eye.
  onScreen(point: Vector3): { x: number; y: number } | undefined {
    const p = point.clone().project(this.orbit.camera);
    if (p.z > 1 || p.z < -1) return undefined;
    return { x: ((p.x + 1) / 2) * this.canvas.clientWidth, y: ((1 - p.y) / 2) * this.canvas.clientHeight };
  }
}
