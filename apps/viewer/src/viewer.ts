// What the reader sees follows from the state: every action changes the state and calls `show`.
import { Box3, Object3D, Vector3 } from 'three';
import { objectA, objectB, themes, touchedColour, untouched } from './colours';
import type { HierarchyLayer, Layer, LayerStep, PageData } from './data';
import { drawLevel, litTriangles, nodeUnder, trianglesHeld, type DrawnLevel } from './hierarchy';
import { draw, merged, points, segments } from './layers';
import { Marks, type Mark } from './marks';
import { Objects, type Appearance } from './objects';
import { element, Panels } from './panels';
import { isSetFor } from './tree';
import { LayerPanel } from './layer_panel';
import { Stage } from './stage';
import { fromHash, toHash, type Known } from './link';
import type { State } from './state';
import { countText, lengthText } from './words';

function knownOf({ header, report }: PageData): Known {
  return {
    pairs: report.pairs.length,
    objects: report.objects.length,
    sliders: header.layers.flatMap(({ steps }, layer) => (steps && steps.length > 0 ? [{ layer, steps: steps.length }] : [])),
    roles: new Set(header.layers.map((layer) => layer.role)),
  };
}

export class Viewer {
  readonly state: State;
  readonly stage: Stage;
  private readonly objects: Objects;
  readonly panels: Panels;
  private readonly layerPanel: LayerPanel;
  private readonly marks: Marks;
  private readonly touched: Set<number>;
  private readonly known: Known;
  private linkTimer = 0;
  private levels: DrawnLevel[] = [];
  private litNode = -1;

  constructor(readonly data: PageData) {
    const { header, report } = data;
    this.known = knownOf(data);
    const { state, complaints } = fromHash(location.hash, this.known);
    this.state = state;
    this.touched = new Set(report.pairs.flatMap((pair) => (pair.relation === 'apart' ? [] : [pair.a_index, pair.b_index])));
    this.objects = new Objects(data);
    this.stage = new Stage(element<HTMLCanvasElement>('canvas'), data, this.objects, () => this.afterDrawing());
    this.marks = new Marks(this.stage, header, report.unit);
    this.layerPanel = new LayerPanel(data, this.state, () => this.show());
    this.panels = new Panels(data, this.state, {
      choosePair: (pair) => this.choosePair(pair),
      focus: (objects) => this.stage.frameBox(this.boxAround(objects)),
      toggle: (objects, what) => this.toggle(objects, what),
      colourOf: (object) => this.colourOf(object),
    });
    this.noticeIfEmpty();
    this.complain(complaints);
    this.openHierarchy();
    this.show();
    this.panels.markPair();
    this.placeCamera();
  }

  private placeCamera(): void {
    const camera = this.state.camera;
    if (!camera) return this.frame();
    const { place } = this.stage.orbit;
    place.target.set(camera[0], camera[1], camera[2]);
    [place.distance, place.yaw, place.pitch] = camera.slice(3);
    this.stage.orbit.apply();
    this.stage.redraw();
  }

  /// A page without contacts that has a hierarchy shows it at once, unless a link says otherwise.
  private openHierarchy(): void {
    const { header, report } = this.data;
    const layer = header.layers.findIndex((one) => one.kind === 'hierarchy');
    if (layer < 0 || report.pairs.length > 0 || location.hash.length > 1) return;
    this.state.steps.set(layer, Math.min(3, (header.layers[layer].steps?.length ?? 1) - 1));
  }

  private noticeIfEmpty(): void {
    const notice = element('notice');
    notice.hidden = this.data.report.objects.length > 0;
    notice.textContent = 'This scene is empty: it holds no object.';
  }

  /// What the link asks for in vain.
  private complain(complaints: string[]): void {
    element('complaint').hidden = complaints.length === 0;
    const text = complaints.map((complaint) => `${complaint}.`).join(' ');
    element('complaint-text').textContent = `The link to this view is not understood in all: ${text}`;
  }

  private boxAround(objects: number[]): Box3 {
    return objects.reduce((box, object) => box.union(this.objects.boxes[object]), new Box3());
  }

  private colourOf(object: number): number {
    const { pair } = this.state;
    if (pair !== undefined) {
      if (object === this.data.report.pairs[pair].a_index) return objectA;
      if (object === this.data.report.pairs[pair].b_index) return objectB;
      return untouched;
    }
    return this.touched.has(object) ? touchedColour(object) : untouched;
  }

  /// The objects of which a level is drawn.
  private opened(): Set<number> {
    const objects = new Set<number>();
    this.data.header.layers.forEach((layer, i) => {
      if (layer.kind === 'hierarchy' && this.state.steps.has(i)) objects.add(layer.object ?? -1);
    });
    return objects;
  }

  private lookOf(object: number, opened: Set<number>): Appearance['look'] {
    const { state } = this;
    if (state.hidden.has(object) || (state.only && !state.only.has(object))) return 'hidden';
    if (state.ghosts.has(object)) return 'ghost';
    if (opened.has(object)) return 'hidden'; // its triangles are drawn in the colours of the level
    if (state.pair === undefined) return opened.size > 0 ? state.rest : 'shown';
    const pair = this.data.report.pairs[state.pair];
    if (object !== pair.a_index && object !== pair.b_index) return state.rest;
    const outer = pair.containment === 'a_in_b' ? pair.b_index : pair.containment === 'b_in_a' ? pair.a_index : -1;
    return object === outer ? 'ghost' : 'shown';
  }

  /// Everything anew from the state.
  show(): void {
    const { state } = this;
    const theme = themes[state.theme];
    document.documentElement.dataset.theme = state.theme;
    document.documentElement.dataset.panels = state.panels ? 'on' : 'off';
    this.objects.seeThrough(state.through);
    const opened = this.opened();
    const looks = this.data.report.objects.map((_, i) => ({ look: this.lookOf(i, opened), colour: this.colourOf(i) }));
    if (state.pair !== undefined) this.colourContainer(looks, state.pair);
    this.objects.show(looks, theme.ghost);
    this.stage.setTheme(theme, state.grid);
    this.layerPanel.show();
    this.stage.setOverlays(this.overlays());
    this.marks.set(state.labels ? this.labels() : []);
    this.showButtons();
  }

  /// The ghost that contains the other one is still told by its colour.
  private colourContainer(looks: Appearance[], index: number): void {
    const pair = this.data.report.pairs[index];
    for (const object of [pair.a_index, pair.b_index]) looks[object].ghostColour = looks[object].colour;
  }

  private showButtons(): void {
    const { state } = this;
    element('rest').textContent = `Rest: ${state.rest}`;
    element('theme').textContent = state.theme === 'dark' ? 'Light' : 'Dark';
    for (const name of ['through', 'grid', 'labels'] as const) element(name).setAttribute('aria-pressed', String(state[name]));
  }

  private overlays(): Object3D[] {
    const { header } = this.data;
    this.levels = [];
    this.light(undefined, -1);
    const ofPair = header.layers.filter((layer) => layer.pair === this.state.pair && !this.state.off.has(layer.role));
    const drawn = this.state.pair === undefined ? this.allContacts() : ofPair.map((layer) => this.drawn(layer));
    header.layers.forEach((layer, i) => {
      if (layer.pair !== undefined || this.state.off.has(layer.role)) return;
      const chosen = this.state.steps.get(i);
      if (!layer.steps) drawn.push(this.drawn(layer));
      else if (chosen !== undefined && layer.steps[chosen]) drawn.push(this.drawn(layer, layer.steps[chosen], chosen));
    });
    return drawn;
  }

  private drawn(layer: Layer, step?: LayerStep, stepNumber = 0): Object3D {
    if (layer.kind === 'hierarchy' && step) {
      const { drawn, level } = drawLevel(layer as HierarchyLayer, step, this.data, this.objects);
      this.levels.push(level);
      return drawn;
    }
    const size = this.focusBox().getSize(new Vector3()).length();
    const style = { theme: themes[this.state.theme], over: layer.pair !== undefined, arrow: 0.12 * size, step, stepNumber };
    return draw(layer, { data: this.data, objects: this.objects }, style);
  }

  /// While no pair is chosen, the curves and points of all of them: one drawing each.
  private allContacts(): Object3D[] {
    const { header } = this.data;
    if (this.state.off.has('contact')) return [];
    const colour = themes[this.state.theme].contact;
    const of = (kind: string) => header.layers.filter((layer) => layer.pair !== undefined && layer.role === 'contact' && layer.kind === kind);
    const curves = merged(of('segments'), this.data);
    const places = merged(of('points'), this.data);
    const drawn: Object3D[] = [];
    if (curves.length > 0) drawn.push(segments(curves, colour, 2.5, false));
    if (places.length > 0) drawn.push(points(places, colour, false));
    return drawn;
  }

  /// Lights up the triangles of the node under the pointer, while a level is drawn.
  hover(x: number, y: number): void {
    if (this.levels.length === 0) return;
    const ray = this.stage.rayAt(x, y);
    for (const level of this.levels) {
      const node = nodeUnder(level, ray, this.data);
      if (node !== undefined) return this.light(level, node);
    }
    this.light(undefined, -1);
  }

  private light(level: DrawnLevel | undefined, node: number): void {
    if (node === this.litNode) return;
    this.litNode = node;
    const theme = themes[this.state.theme];
    this.stage.setLit(level && litTriangles(level, node, this.data, this.objects, theme));
    const held = level ? trianglesHeld(level.layer, level.step, node, this.data).length : 0;
    element('hover').textContent = level ? `node ${node} of ${level.step.label}: ${countText(held, 'triangle')}` : '';
  }

  private labels(): Mark[] {
    const { report, header } = this.data;
    if (this.state.pair === undefined) return [];
    const pair = report.pairs[this.state.pair];
    const top = (box: Box3) => {
      const at = box.getCenter(new Vector3());
      const up = header.up === 'z' ? 2 : 1;
      return at.setComponent(up, box.max.getComponent(up));
    };
    const marks: Mark[] = [
      { at: top(this.objects.boxes[pair.a_index]), text: pair.a, className: 'mark a', kept: true },
      { at: top(this.objects.boxes[pair.b_index]), text: pair.b, className: 'mark b', kept: true },
    ];
    for (const layer of header.layers) {
      const text = layer.length === undefined ? layer.label : lengthText(layer.length, report.unit);
      if (layer.pair !== this.state.pair || !text || this.state.off.has(layer.role)) continue;
      const ends = this.data.floats(layer.data);
      marks.push({ at: new Vector3((ends[0] + ends[3]) / 2, (ends[1] + ends[4]) / 2, (ends[2] + ends[5]) / 2), text, className: 'mark' });
    }
    return marks;
  }

  /// Around what was found of the chosen pair; else around what is shown.
  focusBox(): Box3 {
    const { pair } = this.state;
    if (pair === undefined) {
      const box = new Box3();
      const opened = this.opened();
      this.data.report.objects.forEach((object, i) => {
        const isOpened = opened.has(i);
        const counts = opened.size > 0 ? isOpened : this.lookOf(i, opened) !== 'hidden';
        if (counts && object.shape !== 'half-space') box.union(this.objects.boxes[i]);
      });
      return box.isEmpty() ? this.stage.wholeBox() : box;
    }
    const found = new Box3();
    for (const layer of this.data.header.layers) {
      if (layer.pair !== pair || layer.kind === 'faces' || layer.kind === 'arrows') continue;
      const numbers = this.data.floats(layer.data);
      for (let i = 0; i < numbers.length; i += 3) found.expandByPoint(new Vector3(numbers[i], numbers[i + 1], numbers[i + 2]));
    }
    return this.withRoom(found, pair);
  }

  /// A contact that is tiny beside its objects is shown with some of these around it.
  private withRoom(found: Box3, index: number): Box3 {
    const pair = this.data.report.pairs[index];
    const [a, b] = [this.objects.boxes[pair.a_index], this.objects.boxes[pair.b_index]];
    const length = (box: Box3) => box.getSize(new Vector3()).length();
    const [smaller, larger] = length(a) < length(b) ? [a, b] : [b, a];
    if (pair.containment !== 'none' && length(larger) < 4 * length(smaller)) return larger.clone();
    if (found.isEmpty()) return smaller.clone();
    const missing = 0.6 * length(smaller) - length(found);
    const close = missing > 0 ? found.clone().expandByScalar(missing / 2) : found;
    const both = a.clone().union(b);
    const isHalfSpace = [pair.a_index, pair.b_index].some((i) => this.data.report.objects[i].shape === 'half-space');
    return !isHalfSpace && length(both) < 4 * length(close) ? both : close;
  }

  frame(): void {
    this.stage.frameBox(this.focusBox());
  }

  choosePair(pair: number | undefined): void {
    if (pair === undefined && this.state.pair === undefined) return;
    this.state.pair = pair;
    this.panels.markPair();
    this.panels.listObjects();
    this.show();
    this.frame();
  }

  /// All of them, unless they all are so already: then none.
  toggle(objects: number[], what: 'hidden' | 'ghosts' | 'only'): void {
    const { state } = this;
    const isOn = isSetFor(state, objects, what);
    if (what === 'only') state.only = isOn ? undefined : new Set(objects);
    else for (const object of objects) isOn ? state[what].delete(object) : state[what].add(object);
    this.panels.listObjects();
    this.show();
  }

  showAll(): void {
    this.state.hidden.clear();
    this.state.ghosts.clear();
    this.state.only = undefined;
    this.panels.listObjects();
    this.show();
  }

  change(change: (state: State) => void): void {
    change(this.state);
    this.show();
  }

  private afterDrawing(): void {
    this.marks.place();
    window.clearTimeout(this.linkTimer);
    this.linkTimer = window.setTimeout(() => this.rememberLink(), 250);
  }

  link(): string {
    const { place } = this.stage.orbit;
    this.state.camera = [place.target.x, place.target.y, place.target.z, place.distance, place.yaw, place.pitch];
    return toHash(this.state, this.known);
  }

  private rememberLink(): void {
    const hash = this.link();
    if (hash !== location.hash) history.replaceState(null, '', hash);
  }
}
