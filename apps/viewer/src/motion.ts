// Where objects are at each moment of the page's time, as the engine wrote it: what has changed since the moment before.
import { Matrix4, Quaternion, Vector3 } from 'three';
import type { MotionHeader, PageData } from './data';
import type { Objects } from './objects';

const width = { place: 3, turn: 4 };

export class Motion {
  private readonly entries: Uint32Array; // whose place it is
  private readonly places: Float32Array;
  private readonly turns: Int16Array; // quaternions, from the first pose; all 0: it is not there
  private readonly first: Matrix4[]; // at the first pose, about its origin
  private readonly there: boolean[];
  private readonly elsewhere: boolean[]; // it has been seen at another place
  private shown = -1;

  constructor(
    private readonly motion: MotionHeader,
    data: PageData,
    private readonly objects: Objects,
  ) {
    this.entries = data.integers(motion.objects);
    this.places = data.floats(motion.places);
    this.turns = new Int16Array(data.shorts(motion.turns));
    const { frame } = data.header;
    this.first = data.report.objects.map(({ pose }, i) => {
      const [x, y, z] = [0, 1, 2].map((axis) => (pose[9 + axis] - frame.centre[axis]) / frame.size);
      return new Matrix4().makeTranslation(-x, -y, -z).multiply(objects.matrices[i]);
    });
    this.there = this.first.map(() => false);
    this.elsewhere = this.first.map(() => false);
    this.noteWhatMoves();
  }

  private noteWhatMoves(): void {
    const seen = new Set<number>();
    this.entries.forEach((object, i) => {
      if (seen.has(object) && !this.isGone(i)) this.elsewhere[object] = true;
      seen.add(object);
    });
  }

  private isGone(entry: number): boolean {
    return [0, 1, 2, 3].every((i) => this.turns[width.turn * entry + i] === 0);
  }

  isThere = (object: number) => this.there[object];
  moves = (object: number) => this.elsewhere[object];

  /// Places the objects as they are at that moment.
  go(moment: number): void {
    if (moment === this.shown) return;
    const latest = new Map<number, number>(); // entry by object
    const from = moment > this.shown ? this.shown + 1 : 0;
    if (from === 0) this.there.fill(false);
    for (let i = from; i <= moment; ++i) {
      const [first, count] = this.motion.moments[i];
      for (let entry = first; entry < first + count; ++entry) latest.set(this.entries[entry], entry);
    }
    for (const [object, entry] of latest) this.place(object, entry);
    this.shown = moment;
  }

  private place(object: number, entry: number): void {
    this.there[object] = !this.isGone(entry);
    if (!this.there[object]) return;
    const [at, turn] = [width.place * entry, width.turn * entry];
    const rotation = new Quaternion(this.turns[turn], this.turns[turn + 1], this.turns[turn + 2], this.turns[turn + 3]).normalize();
    const matrix = new Matrix4().makeRotationFromQuaternion(rotation);
    matrix.setPosition(new Vector3().fromArray(this.places, at));
    this.objects.setMatrix(object, matrix.multiply(this.first[object]));
  }
}
