// What the reader has chosen, and how it becomes the end of a link.
import type { Look } from './objects';

export interface State {
  pair: number | undefined;
  hidden: Set<number>;
  ghosts: Set<number>;
  only: number | undefined;
  rest: Look; // of the objects that are not of the chosen pair
  through: boolean;
  grid: boolean;
  labels: boolean;
  panels: boolean;
  theme: 'light' | 'dark';
  order: string;
  off: Set<string>; // roles of layers that are switched off
  steps: Map<number, number>; // of layers with steps, which one is shown
  camera: number[] | undefined; // target, distance, yaw, pitch
}

export function newState(): State {
  return {
    pair: undefined,
    hidden: new Set(),
    ghosts: new Set(),
    only: undefined,
    rest: 'ghost',
    through: false,
    grid: true,
    labels: true,
    panels: true,
    theme: window.matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light',
    order: 'deepest',
    off: new Set(),
    steps: new Map(),
    camera: undefined,
  };
}

/// "0-2,5" and back.
function ranges(numbers: Set<number>): string {
  const sorted = [...numbers].sort((a, b) => a - b);
  const parts: string[] = [];
  for (let i = 0; i < sorted.length; ) {
    let end = i;
    while (end + 1 < sorted.length && sorted[end + 1] === sorted[end] + 1) ++end;
    parts.push(end > i ? `${sorted[i]}-${sorted[end]}` : `${sorted[i]}`);
    i = end + 1;
  }
  return parts.join(',');
}

function fromRanges(text: string, below: number): Set<number> {
  const numbers = new Set<number>();
  for (const part of text.split(',').filter((word) => word !== '')) {
    const [first, last = first] = part.split('-').map(Number);
    for (let i = first; i <= Math.min(last, below - 1); ++i) if (i >= 0) numbers.add(i);
  }
  return numbers;
}

export function toHash(state: State): string {
  const words = new URLSearchParams();
  if (state.pair !== undefined) words.set('pair', `${state.pair}`);
  if (state.only !== undefined) words.set('only', `${state.only}`);
  if (state.hidden.size > 0) words.set('hidden', ranges(state.hidden));
  if (state.ghosts.size > 0) words.set('ghosts', ranges(state.ghosts));
  if (state.rest !== 'ghost') words.set('rest', state.rest);
  if (state.through) words.set('through', '1');
  if (!state.grid) words.set('grid', '0');
  if (!state.labels) words.set('labels', '0');
  if (!state.panels) words.set('panels', '0');
  if (state.order !== 'deepest') words.set('order', state.order);
  if (state.off.size > 0) words.set('off', [...state.off].join(','));
  if (state.steps.size > 0) words.set('steps', [...state.steps].map((entry) => entry.join(':')).join(','));
  words.set('theme', state.theme);
  if (state.camera) words.set('camera', state.camera.map((x) => Number(x.toPrecision(7))).join(','));
  return '#' + words.toString().replace(/%2C/g, ',').replace(/%3A/g, ':');
}

/// Words that are not understood are left aside.
export function fromHash(hash: string, objects: number, pairs: number): State {
  const state = newState();
  const words = new URLSearchParams(hash.replace(/^#/, ''));
  const index = (name: string, below: number) => {
    const text = words.get(name);
    const number = text === null ? NaN : Number(text);
    return Number.isInteger(number) && number >= 0 && number < below ? number : undefined;
  };
  state.pair = index('pair', pairs);
  state.only = index('only', objects);
  state.hidden = fromRanges(words.get('hidden') ?? '', objects);
  state.ghosts = fromRanges(words.get('ghosts') ?? '', objects);
  const rest = words.get('rest');
  if (rest === 'shown' || rest === 'hidden') state.rest = rest;
  state.through = words.get('through') === '1';
  state.grid = words.get('grid') !== '0';
  state.labels = words.get('labels') !== '0';
  state.panels = words.get('panels') !== '0';
  const theme = words.get('theme');
  if (theme === 'light' || theme === 'dark') state.theme = theme;
  state.order = words.get('order') ?? state.order;
  state.off = new Set((words.get('off') ?? '').split(',').filter((word) => word !== ''));
  for (const entry of (words.get('steps') ?? '').split(',').filter((word) => word !== '')) {
    const [layer, step] = entry.split(':').map(Number);
    if (Number.isInteger(layer) && Number.isInteger(step)) state.steps.set(layer, step);
  }
  const camera = (words.get('camera') ?? '').split(',').map(Number);
  if (camera.length === 6 && camera.every(Number.isFinite)) state.camera = camera;
  return state;
}
