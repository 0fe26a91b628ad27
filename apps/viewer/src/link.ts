// How the state becomes the end of a link, and back. What a link asks for and the page does not have is told in words.
import { newState, type State } from './state';

/// What there is to be asked for.
export interface Known {
  findings: number;
  objects: number;
  sliders: { layer: number; steps: number }[]; // counted in links in this order
  roles: Set<string>;
  moments: number;
}

/// "0-2,5"
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

export function toHash(state: State, known: Known): string {
  const words = new URLSearchParams();
  if (state.finding !== undefined) words.set('finding', `${state.finding}`);
  if (state.only) words.set('only', ranges(state.only));
  if (state.hidden.size > 0) words.set('hidden', ranges(state.hidden));
  if (state.ghosts.size > 0) words.set('ghosts', ranges(state.ghosts));
  if (state.rest !== 'ghost') words.set('rest', state.rest);
  if (state.through) words.set('through', '1');
  if (!state.grid) words.set('grid', '0');
  if (!state.labels) words.set('labels', '0');
  if (!state.panels) words.set('panels', '0');
  if (!state.card) words.set('card', '0');
  if (state.order) words.set('order', state.order);
  if (state.off.size > 0) words.set('off', [...state.off].join(','));
  const steps = known.sliders.flatMap(({ layer }, slider) => (state.steps.has(layer) ? [`${slider}:${state.steps.get(layer)}`] : []));
  if (steps.length > 0) words.set('steps', steps.join(','));
  if (state.moment > 0) words.set('moment', `${state.moment}`);
  words.set('theme', state.theme);
  if (state.camera) words.set('camera', state.camera.map((x) => Number(x.toPrecision(7))).join(','));
  return '#' + words.toString().replace(/%2C/g, ',').replace(/%3A/g, ':');
}

const placesOf = (count: number, what: string) =>
  count === 0 ? `this page has no ${what}` : `here ${what}s are 0${count > 1 ? ` to ${count - 1}` : ' alone'}`;

class Reader {
  readonly state = newState();
  readonly complaints: string[] = [];

  constructor(private readonly known: Known) {}

  read(words: URLSearchParams): void {
    const seen = new Set<string>();
    for (const [key, text] of words) {
      const read = this.readers[key];
      if (!read) this.complaints.push(`“${key}” is nothing that a link can say`);
      else if (seen.has(key)) this.complaints.push(`“${key}” is said twice`);
      else read(text);
      seen.add(key);
    }
  }

  private index(text: string, count: number, what: string): number | undefined {
    if (/^\d+$/.test(text) && Number(text) < count) return Number(text);
    this.complaints.push(`there is no ${what} “${text}”: ${placesOf(count, what)}`);
    return undefined;
  }

  private objects(text: string): Set<number> {
    const numbers = new Set<number>();
    for (const part of text.split(',').filter((word) => word !== '')) {
      const ends = part.split('-', 2).map((end) => this.index(end, this.known.objects, 'object'));
      const [first, last = first] = ends;
      if (first === undefined || last === undefined || ends.includes(undefined)) continue;
      for (let i = first; i <= last; ++i) numbers.add(i);
    }
    return numbers;
  }

  private oneOf<T extends string>(key: string, text: string, values: readonly T[]): T | undefined {
    const found = values.find((value) => value === text);
    if (!found) this.complaints.push(`“${key}” is one of ${values.join(', ')}, and not “${text}”`);
    return found;
  }

  private flag(key: 'through' | 'grid' | 'labels' | 'panels' | 'card', text: string): void {
    const value = this.oneOf(key, text, ['0', '1']);
    if (value) this.state[key] = value === '1';
  }

  private steps(text: string): void {
    const { sliders } = this.known;
    for (const entry of text.split(',').filter((word) => word !== '')) {
      const [slider, step = ''] = entry.split(':', 2);
      const at = this.index(slider, sliders.length, 'slider');
      if (at === undefined) continue;
      const shown = this.index(step, sliders[at].steps, 'step');
      if (shown !== undefined) this.state.steps.set(sliders[at].layer, shown);
    }
  }

  private camera(text: string): void {
    const numbers = text.split(',').map((word) => (word === '' ? NaN : Number(word)));
    if (numbers.length === 6 && numbers.every(Number.isFinite) && numbers[3] > 0) this.state.camera = numbers;
    else this.complaints.push('“camera” is six numbers, of which the fourth, a distance, is above 0');
  }

  private off(text: string): void {
    for (const role of text.split(',').filter((word) => word !== ''))
      if (this.known.roles.has(role)) this.state.off.add(role);
      else this.complaints.push(`there is nothing to switch off that is called “${role}”`);
  }

  private readonly readers: Record<string, (text: string) => void> = {
    finding: (text) => (this.state.finding = this.index(text, this.known.findings, 'finding')),
    only: (text) => {
      const objects = this.objects(text);
      if (objects.size > 0) this.state.only = objects;
    },
    hidden: (text) => (this.state.hidden = this.objects(text)),
    ghosts: (text) => (this.state.ghosts = this.objects(text)),
    rest: (text) => (this.state.rest = this.oneOf('rest', text, ['ghost', 'shown', 'hidden']) ?? this.state.rest),
    through: (text) => this.flag('through', text),
    grid: (text) => this.flag('grid', text),
    labels: (text) => this.flag('labels', text),
    panels: (text) => this.flag('panels', text),
    card: (text) => this.flag('card', text),
    moment: (text) => (this.state.moment = this.index(text, this.known.moments, 'moment') ?? 0),
    theme: (text) => (this.state.theme = this.oneOf('theme', text, ['light', 'dark']) ?? this.state.theme),
    order: (text) => (this.state.order = this.oneOf('order', text, ['deepest', 'largest', 'nearest', 'listed']) ?? this.state.order),
    off: (text) => this.off(text),
    steps: (text) => this.steps(text),
    camera: (text) => this.camera(text),
  };
}

/// The state that a link asks for, and a sentence for each thing that it asks for in vain.
export function fromHash(hash: string, known: Known): { state: State; complaints: string[] } {
  const reader = new Reader(known);
  reader.read(new URLSearchParams(hash.replace(/^#/, '')));
  return { state: reader.state, complaints: reader.complaints };
}
