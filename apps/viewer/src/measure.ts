// Lengths between points that are clicked.
import { Vector3 } from 'three';
import type { Header, Vec } from './data';
import type { Mark } from './marks';
import { lengthText, vectorText } from './words';

const sum = (points: Vector3[], component: number) => points.reduce((total, p) => total + p.getComponent(component), 0);

export class Measure {
  active = false;
  private points: Vector3[] = []; // shown; two belong together

  constructor(
    private readonly header: Header,
    private readonly unit: string,
  ) {}

  toggle(): void {
    this.active = !this.active;
    if (!this.active) this.points = [];
  }

  add(point: Vector3): void {
    if (this.points.length === 2) this.points = [];
    this.points.push(point.clone());
  }

  /// The ends of the lines that are drawn, three numbers each.
  ends(): Float32Array {
    return new Float32Array(this.points.length === 2 ? this.points.flatMap((p) => p.toArray()) : []);
  }

  private inWorld(p: Vector3): Vec {
    const { centre, size } = this.header.frame;
    return [p.x * size + centre[0], p.y * size + centre[1], p.z * size + centre[2]];
  }

  /// In words; empty while nothing was clicked.
  text(): string {
    if (!this.active) return '';
    if (this.points.length === 0) return 'Measure: click a point, then another';
    const [from, to] = this.points;
    if (!to) return `From ${vectorText(this.inWorld(from))}: click the other point`;
    const { size } = this.header.frame;
    const along = new Vector3().subVectors(to, from).multiplyScalar(size);
    return `${lengthText(along.length(), this.unit)}, along the axes ${vectorText([Math.abs(along.x), Math.abs(along.y), Math.abs(along.z)])}`;
  }

  marks(): Mark[] {
    const { points } = this;
    if (points.length < 2) return points.map((at) => ({ at, text: '+', className: 'mark' }));
    const middle = new Vector3(sum(points, 0) / 2, sum(points, 1) / 2, sum(points, 2) / 2);
    const length = points[0].distanceTo(points[1]) * this.header.frame.size;
    return [{ at: middle, text: lengthText(length, this.unit), className: 'mark measured' }];
  }
}
