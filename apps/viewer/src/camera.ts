// A camera that turns around a point. It draws nothing by itself; `changed` is told of every move.
import { PerspectiveCamera, Vector3 } from 'three';

export interface CameraPlace {
  target: Vector3;
  distance: number;
  yaw: number;
  pitch: number;
}

/// The part of the picture that nothing covers: how far its middle is to the right of that of the canvas and above it, and its
/// smaller side, in heights of the canvas.
export interface FreePart {
  right: number;
  up: number;
  side: number;
}

const steepest = Math.PI / 2 - 0.001;

export class Orbit {
  readonly camera = new PerspectiveCamera(35, 1, 0.01, 10);
  place: CameraPlace = { target: new Vector3(), distance: 4, yaw: -0.9, pitch: 0.45 };
  private pointers = new Map<number, { x: number; y: number }>();
  private free: FreePart | undefined;

  constructor(
    private readonly element: HTMLElement,
    private readonly up: 'y' | 'z',
    private readonly changed: () => void,
  ) {
    this.camera.up.set(0, up === 'y' ? 1 : 0, up === 'z' ? 1 : 0);
    this.listen();
    this.apply();
  }

  /// From the target to the eye, of length 1.
  private towards(): Vector3 {
    const { yaw, pitch } = this.place;
    const flat = Math.cos(pitch);
    const [x, y, z] = [flat * Math.cos(yaw), flat * Math.sin(yaw), Math.sin(pitch)];
    return this.up === 'z' ? new Vector3(x, y, z) : new Vector3(x, z, -y);
  }

  apply(): void {
    const { target, distance } = this.place;
    this.camera.position.copy(target).addScaledVector(this.towards(), distance);
    this.camera.lookAt(target);
    this.camera.near = distance * 0.02;
    this.camera.far = distance + 12;
    this.aim();
    this.camera.updateMatrixWorld();
  }

  /// So that the target is drawn in the middle of what is free.
  private aim(): void {
    const { clientWidth: width, clientHeight: height } = this.element;
    if (this.free && height > 0) this.camera.setViewOffset(width, height, -this.free.right * height, this.free.up * height, width, height);
    else this.camera.clearViewOffset();
    this.camera.updateProjectionMatrix();
  }

  /// Where there is none, all of the picture is free.
  keepClear(free: FreePart | undefined): void {
    this.free = free;
    this.aim();
  }

  private move(): void {
    this.apply();
    this.changed();
  }

  resize(width: number, height: number): void {
    this.camera.aspect = width / height;
    this.apply();
  }

  /// Shows a ball whole.
  frame(centre: Vector3, radius: number): void {
    const half = (this.camera.fov * Math.PI) / 360;
    const side = this.free?.side ?? Math.min(1, this.camera.aspect);
    this.place.target.copy(centre);
    this.place.distance = Math.max((1.15 * radius) / Math.sin(half) / side, 1e-7);
    this.move();
  }

  look(yaw: number, pitch: number): void {
    this.place.yaw = yaw;
    this.place.pitch = Math.max(-steepest, Math.min(steepest, pitch));
    this.move();
  }

  turn(right: number, up: number): void {
    this.look(this.place.yaw - right, this.place.pitch + up);
  }

  /// Moves along the screen, in its heights.
  pan(right: number, up: number): void {
    const across = 2 * Math.tan((this.camera.fov * Math.PI) / 360) * this.place.distance;
    const e = this.camera.matrixWorld.elements;
    this.place.target.addScaledVector(new Vector3(e[0], e[1], e[2]), right * across);
    this.place.target.addScaledVector(new Vector3(e[4], e[5], e[6]), up * across);
    this.move();
  }

  /// `factor` below 1 comes nearer; the point at (right, up) of the target, in screen heights, stays where it is.
  zoom(factor: number, right = 0, up = 0): void {
    const before = this.place.distance;
    this.place.distance = Math.max(1e-7, Math.min(100, before * factor));
    const moved = before / this.place.distance - 1;
    this.pan(right * moved, up * moved);
  }

  private listen(): void {
    const element = this.element;
    element.addEventListener('contextmenu', (event) => event.preventDefault());
    element.addEventListener('pointerdown', (event) => {
      element.setPointerCapture(event.pointerId);
      this.pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    });
    const gone = (event: PointerEvent) => this.pointers.delete(event.pointerId);
    element.addEventListener('pointerup', gone);
    element.addEventListener('pointercancel', gone);
    element.addEventListener('pointermove', (event) => this.drag(event));
    element.addEventListener(
      'wheel',
      (event) => {
        event.preventDefault();
        const box = element.getBoundingClientRect();
        const right = (event.clientX - box.left - box.width / 2) / box.height - (this.free?.right ?? 0);
        const up = (box.top + box.height / 2 - event.clientY) / box.height - (this.free?.up ?? 0);
        this.zoom(Math.exp(Math.max(-1, Math.min(1, event.deltaY * 0.0015))), right, up);
      },
      { passive: false },
    );
  }

  private drag(event: PointerEvent): void {
    const before = this.pointers.get(event.pointerId);
    if (!before) return;
    const height = this.element.clientHeight;
    const dx = (event.clientX - before.x) / height;
    const dy = (event.clientY - before.y) / height;
    if (this.pointers.size === 2) this.pinch(event, before);
    this.pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    const pans = this.pointers.size === 2 || event.shiftKey || (event.buttons & 6) !== 0;
    if (pans) this.pan(-dx / this.pointers.size, dy / this.pointers.size);
    else this.turn(dx * 4, dy * 4);
  }

  private pinch(event: PointerEvent, before: { x: number; y: number }): void {
    for (const [id, other] of this.pointers) {
      if (id === event.pointerId) continue;
      const apart = Math.hypot(event.clientX - other.x, event.clientY - other.y);
      if (apart > 0) this.zoom(Math.hypot(before.x - other.x, before.y - other.y) / apart);
    }
  }
}
