// Words over the picture: names and numbers at their places, the axes, and the bar that tells lengths.
import { Vector3 } from 'three';
import type { Header } from './data';
import { roundLength } from './grid';
import { element, make } from './panels';
import type { Stage } from './stage';
import { lengthText } from './words';

export interface Mark {
  at: Vector3;
  text: string;
  className: string;
  kept?: boolean; // at the edge of the picture where its place is outside
}

const edge = { x: 70, y: 44 };

const axisNames = ['X', 'Y', 'Z'];
const axisColours = ['#d55e00', '#009e73', '#0072b2'];

interface Rectangle {
  left: number;
  right: number;
  top: number;
  bottom: number;
}

/// Moves the place of a word to the nearest side of the rectangle where it would cover it. A word is drawn above its place.
function keepOff(at: { x: number; y: number }, word: HTMLElement, place: Rectangle): void {
  const [width, height] = [word.offsetWidth || 80, word.offsetHeight || 22];
  const room = 6;
  const [top, bottom] = [at.y - 1.5 * height, at.y - 0.5 * height];
  const covers = at.x + width / 2 > place.left && at.x - width / 2 < place.right && bottom > place.top && top < place.bottom;
  if (!covers) return;
  const ways = [
    { by: bottom - place.top, move: () => (at.y = place.top - room + 0.5 * height) },
    { by: place.bottom - top, move: () => (at.y = place.bottom + room + 1.5 * height) },
    { by: at.x + width / 2 - place.left, move: () => (at.x = place.left - room - width / 2) },
    { by: place.right - at.x + width / 2, move: () => (at.x = place.right + room + width / 2) },
  ];
  ways.sort((x, y) => x.by - y.by)[0].move();
}

export class Marks {
  private marks: { mark: Mark; element: HTMLElement }[] = [];

  constructor(
    private readonly stage: Stage,
    private readonly header: Header,
    private readonly unit: string,
  ) {}

  /// What no word may cover: its corners, in shown coordinates.
  avoid: Vector3[] = [];

  set(marks: Mark[]): void {
    const made = marks.map((mark) => ({ mark, element: make('div', mark.text, mark.className) }));
    element('marks').replaceChildren(...made.map((entry) => entry.element));
    this.marks = made;
  }

  get all(): Mark[] {
    return this.marks.map((entry) => entry.mark);
  }

  place(): void {
    const taken: { x: number; y: number }[] = [];
    const place = this.placeOnScreen();
    for (const { mark, element: shown } of this.marks) {
      const at = this.stage.onScreen(mark.at);
      shown.hidden = !at;
      if (!at) continue;
      if (mark.kept) this.keepInside(at);
      if (place) keepOff(at, shown, place);
      while (taken.some((other) => Math.abs(other.x - at.x) < 150 && Math.abs(other.y - at.y) < 24)) at.y += 6;
      taken.push(at);
      Object.assign(shown.style, { left: `${at.x}px`, top: `${at.y}px` });
    }
    this.placeAxes();
    this.placeScale();
  }

  /// The part of the screen that the place takes; none where it is most of it, so that a word has to lie over it.
  private placeOnScreen(): Rectangle | undefined {
    const corners = this.avoid.map((corner) => this.stage.onScreen(corner));
    if (corners.length === 0 || corners.some((corner) => !corner)) return undefined;
    const [xs, ys] = [corners.map((corner) => corner!.x), corners.map((corner) => corner!.y)];
    const rectangle = { left: Math.min(...xs), right: Math.max(...xs), top: Math.min(...ys), bottom: Math.max(...ys) };
    const { clientWidth, clientHeight } = this.stage.canvas;
    const isMost = rectangle.right - rectangle.left > 0.8 * clientWidth && rectangle.bottom - rectangle.top > 0.8 * clientHeight;
    return isMost ? undefined : rectangle;
  }

  private keepInside(at: { x: number; y: number }): void {
    const { clientWidth, clientHeight } = this.stage.canvas;
    at.x = Math.min(Math.max(at.x, edge.x), clientWidth - edge.x);
    at.y = Math.min(Math.max(at.y, edge.y), clientHeight - edge.y);
  }

  private view = ''; // from which the axes are drawn

  private placeAxes(): void {
    const e = this.stage.orbit.camera.matrixWorldInverse.elements;
    const ends = [0, 1, 2].map((axis) => ({ axis, x: e[4 * axis] * 32, y: -e[4 * axis + 1] * 32, z: e[4 * axis + 2] }));
    const view = e.slice(0, 11).join();
    if (view === this.view) return;
    this.view = view;
    ends.sort((a, b) => a.z - b.z);
    const parts = ends.map(({ axis, x, y }) => {
      const [tx, ty] = [x * 1.32, y * 1.32];
      return `<line x1="0" y1="0" x2="${x}" y2="${y}" stroke="${axisColours[axis]}"/><text x="${tx}" y="${ty}">${axisNames[axis]}</text>`;
    });
    document.getElementById('axes')!.innerHTML = parts.join('');
  }

  /// How long a round length is on the screen, at the distance of what is looked at.
  private placeScale(): void {
    const { camera, place } = this.stage.orbit;
    const height = 2 * Math.tan((camera.fov * Math.PI) / 360) * place.distance;
    const perPixel = height / this.stage.canvas.clientHeight; // shown
    const { size } = this.header.frame;
    const length = roundLength(Math.min(perPixel * 140 * size, Number.MAX_VALUE));
    const [bar, text] = element('scale').children as unknown as [HTMLElement, HTMLElement];
    const width = `${Math.round((10 * length) / size / perPixel) / 10}px`;
    const told = lengthText(length, this.unit);
    if (bar.style.width === width && text.textContent === told) return; // what is written is drawn anew, also where it is the same
    bar.style.width = width;
    text.textContent = told;
  }
}
