// The picture: objects, layers, axes and grid, drawn only when something changed.
import { Color, DirectionalLight, Group, HemisphereLight, Object3D, Plane, Raycaster, Scene, Vector2, Vector3, WebGLRenderer, Box3 } from 'three';
import { Orbit } from './camera';
import { levels } from './coarse';
import type { Theme } from './colours';
import { gridLines } from './grid';
import { discard, thinOut } from './layers';
import { boxOfBodies, mostBoxes } from './moving';
import type { Objects } from './objects';
import type { PageData } from './data';

const patience = 250; // milliseconds of rest, after which all is drawn
const slow = 40; // milliseconds of a frame
const tooOften = 3; // slow frames one after the other, while the picture moves

export class Stage {
  readonly renderer: WebGLRenderer;
  readonly orbit: Orbit;
  drawn = 0; // frames, for tests
  isWhole = true; // all triangles are drawn, and not fewer while the picture moves
  private isSlow: boolean; // drawing all of them takes too long to be done while it moves
  private level = 0; // of detail while it moves
  private slowFrames = 0; // the last ones that moved
  private asked = 0; // when a frame was asked for
  private isMoving = false; // the picture has, since the last frame
  private rest = 0; // the timer that waits for the picture to rest
  private finest = Math.min(2, window.devicePixelRatio); // points of the screen for one of the page's
  private readonly isSmooth: boolean; // edges are
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
    isPicture: boolean, // and nobody turns it
    private readonly afterDrawing: () => void,
  ) {
    // What are so many are a few points wide each: smooth edges would take a card that is a program most of its time. So they would
    // of heavy meshes, of which twice as many points of the screen are drawn where a card is found to be quick.
    const most = Math.max(mostBoxes(data), data.report.objects?.length ?? 0);
    this.isSlow = objects.isHeavy; // until it is known
    this.isSmooth = most < 10_000 && (isPicture || !objects.isHeavy);
    this.renderer = new WebGLRenderer({ canvas, antialias: this.isSmooth, stencil: true });
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

  /// Asks for a frame while the picture moves: of fewer triangles and less fine where all would take too long, until it rests.
  private moved(): void {
    if (this.isSlow) this.drawCoarse();
    this.isMoving = true;
    this.redraw();
  }

  private drawCoarse(): void {
    const wasWhole = this.isWhole;
    this.isWhole = false;
    if (wasWhole) this.setLevel(this.level);
    window.clearTimeout(this.rest);
    this.rest = window.setTimeout(() => this.drawWhole(), patience);
  }

  private setLevel(level: number): void {
    this.level = level;
    this.slowFrames = 0;
    this.objects.setDetail(levels[level].triangles, levels[level].backs || this.section !== undefined);
    this.thinOutLayers();
    this.renderer.setPixelRatio(this.finest * levels[level].fineness);
  }

  private thinOutLayers(): void {
    for (const drawn of this.overlays.children) thinOut(drawn, this.isWhole ? 1 : levels[this.level].points);
  }

  /// How long a frame that was asked for while the picture moves had to wait for those before it: where that is long again and
  /// again, less is drawn from here on.
  waited(milliseconds: number): void {
    this.slowFrames = milliseconds > slow ? this.slowFrames + 1 : 0;
    if (this.slowFrames < tooOften) return;
    if (this.isWhole) {
      this.isSlow = true;
      this.drawCoarse();
    } else if (this.level + 1 < levels.length) this.setLevel(this.level + 1);
  }

  private drawWhole(): void {
    if (this.drawn === 0) return this.drawCoarse(); // the first picture comes soon
    if (!this.isWhole) this.renderer.setPixelRatio(this.finest);
    this.objects.setDetail(undefined);
    this.isWhole = true;
    this.thinOutLayers();
    const took = this.timeOfDrawing();
    this.isSlow = took > slow;
    if (this.isSmooth || 4 * took > slow || this.finest === 2) return;
    this.finest = 2;
    this.renderer.setPixelRatio(this.finest);
    this.drawNow();
  }

  private timeOfDrawing(): number {
    const before = performance.now();
    this.drawNow();
    const context = this.renderer.getContext();
    context.readPixels(0, 0, 1, 1, context.RGBA, context.UNSIGNED_BYTE, new Uint8Array(4)); // waits until it is drawn
    return performance.now() - before;
  }

  /// Asks for a frame. However often it is asked, one is drawn.
  redraw(): void {
    if (this.waiting) return;
    this.waiting = true;
    this.asked = performance.now();
    requestAnimationFrame(() => {
      if (this.isMoving) this.waited(performance.now() - this.asked);
      this.isMoving = false;
      this.drawNow();
    });
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
    this.thinOutLayers();
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
    if (!this.isWhole) this.setLevel(this.level);
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
    if (!this.isWhole) this.objects.setDetail(undefined); // rays meet all triangles, also their backs
    const hit = this.objects.hit(this.rayAt(x, y), (point) => !this.section || this.section.distanceToPoint(point) >= 0);
    if (!this.isWhole) this.setLevel(this.level);
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
