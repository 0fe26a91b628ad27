// What the reader has chosen.
import type { Order } from './findings';
import type { Look } from './objects';

export interface State {
  finding: number | undefined;
  hidden: Set<number>;
  ghosts: Set<number>;
  only: Set<number> | undefined; // where there are such, all others are hidden
  rest: Look; // of the objects that the chosen finding is not about
  through: boolean;
  grid: boolean;
  labels: boolean;
  panels: boolean;
  card: boolean; // that tells of what is chosen
  theme: 'light' | 'dark';
  order: Order | undefined; // of the list; none: that of the kind of question
  off: Set<string>; // roles of layers that are switched off
  steps: Map<number, number>; // of layers with steps, which one is shown
  moment: number; // of the page's time
  camera: number[] | undefined; // target, distance, yaw, pitch
}

export function newState(): State {
  return {
    finding: undefined,
    hidden: new Set(),
    ghosts: new Set(),
    only: undefined,
    rest: 'ghost',
    through: false,
    grid: true,
    labels: true,
    panels: true,
    card: true,
    theme: window.matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light',
    order: undefined,
    off: new Set(),
    steps: new Map(),
    moment: 0,
    camera: undefined,
  };
}
