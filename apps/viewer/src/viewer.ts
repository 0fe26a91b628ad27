// What the reader sees follows from the state: every action changes the state and calls `show`.
import { Box3, Object3D, Vector3 } from 'three';
import type { FreePart } from './camera';
import { bodyColours, objectA, objectB, themes, touchedColour, untouched } from './colours';
import type { HierarchyLayer, Layer, LayerStep, PageData, Vec } from './data';
import { drawLevel, litTriangles, nodeUnder, trianglesHeld, type DrawnLevel } from './hierarchy';
import { findingsOf, type Finding, type Findings } from './findings';
import { areManyCurves, draw, merged, middles, points, roleColour, segments } from './layers';
import { Marks, type Mark } from './marks';
import { Measure } from './measure';
import { Review } from './review';
import { planeOf, type Section } from './section';
import { Objects, type Appearance } from './objects';
import { Motion } from './motion';
import { boxOfBodies } from './moving';
import { element, make, Panels } from './panels';
import { isSetFor } from './tree';
import { LayerPanel } from './layer_panel';
import { Stage } from './stage';
import { TimeBar } from './time_bar';
import { fromHash, toHash, type Known } from './link';
import type { State } from './state';
import { bracketText, countText } from './words';

function knownOf({ header, report }: PageData, findings: Findings): Known {
  return {
    findings: findings.all.length,
    objects: report.objects.length,
    sliders: header.layers.flatMap(({ steps }, layer) => (steps && steps.length > 0 ? [{ layer, steps: steps.length }] : [])),
    roles: new Set(header.layers.map((layer) => layer.role)),
    moments: header.time?.moments.length ?? 0,
  };
}

/// The level at which a hierarchy is first seen; of other layers the last step that is not too much to be looked at.
function firstStep({ kind, steps = [] }: Layer): number {
  if (kind === 'hierarchy') return Math.min(3, steps.length - 1);
  const few = steps.filter(({ count }) => count <= 500).length;
  return Math.max(0, few - 1);
}

function diagonalOf(box: Box3): number {
  return box.getSize(new Vector3()).length();
}

function thinnestOf(box: Box3): number {
  const { x, y, z } = box.getSize(new Vector3());
  return Math.min(x, y, z);
}

/// Ends of the twelve edges of a box, three numbers each.
function edgesOf(box: Box3): number[] {
  const corners = cornersOf(box);
  const ends: number[] = [];
  for (let i = 0; i < 8; ++i)
    for (const bit of [1, 2, 4]) if ((i & bit) === 0) ends.push(...corners[i].toArray(), ...corners[i | bit].toArray());
  return ends;
}

function cornersOf({ min, max }: Box3): Vector3[] {
  return [0, 1, 2, 3, 4, 5, 6, 7].map((i) => new Vector3(i & 1 ? max.x : min.x, i & 2 ? max.y : min.y, i & 4 ? max.z : min.z));
}

const objectsOf = ({ a, b }: Finding) => [...new Set([a, b])].filter((object): object is number => object !== undefined);

export class Viewer {
  readonly state: State;
  readonly stage: Stage;
  private readonly objects: Objects;
  readonly panels: Panels;
  private readonly layerPanel: LayerPanel;
  readonly time: TimeBar;
  private readonly marks: Marks;
  readonly findings: Findings;
  private readonly touched: Set<number>;
  private readonly known: Known;
  private linkTimer = 0;
  private readonly motion: Motion | undefined;
  private meeting = new Set<number>(); // at this moment
  private levels: DrawnLevel[] = [];
  private litNode = -1;
  readonly review = new Review();
  readonly measure: Measure;
  section: Section | undefined;
  private framed: { target: Vector3; distance: number } | undefined; // by the last frame
  private isCloseUp = true; // the place of what is chosen is framed, and not its objects

  constructor(readonly data: PageData) {
    const { header, report } = data;
    this.findings = findingsOf(data);
    this.known = knownOf(data, this.findings);
    const { state, complaints } = fromHash(location.hash, this.known);
    this.state = state;
    this.touched = new Set(this.findings.all.flatMap((finding) => (finding.counts || this.findings.distinct ? objectsOf(finding) : [])));
    this.objects = new Objects(data);
    this.motion = header.motion && new Motion(header.motion, data, this.objects);
    this.state.moment = this.chosen?.moment ?? this.state.moment;
    this.goToMoment();
    this.stage = new Stage(element<HTMLCanvasElement>('canvas'), data, this.objects, !state.panels, () => this.afterDrawing());
    this.stage.afterResizing = () => (this.isFramed ? this.frame() : this.stage.orbit.keepClear(this.freePart()));
    this.marks = new Marks(this.stage, header, report.unit);
    this.layerPanel = new LayerPanel(data, this.findings, this.state, () => this.show());
    this.measure = new Measure(header, report.unit);
    this.panels = new Panels(data, this.findings, this.state, this.review, {
      choose: (finding) => this.choose(finding),
      focus: (objects) => this.stage.frameBox(this.boxAround(objects)),
      toggle: (objects, what) => this.toggle(objects, what),
      colourOf: (object) => this.colourOf(object),
    });
    this.time = new TimeBar(header.time, this.state, () => this.showMoment());
    this.tellSummary();
    this.noticeIfEmpty();
    this.complain(complaints);
    this.openLevels();
    this.show();
    this.panels.markFinding();
    this.placeCamera();
  }

  private placeCamera(): void {
    this.stage.orbit.keepClear(this.freePart());
    const camera = this.state.camera;
    if (!camera) return this.frame();
    const { place } = this.stage.orbit;
    place.target.set(camera[0], camera[1], camera[2]);
    [place.distance, place.yaw, place.pitch] = camera.slice(3);
    this.stage.orbit.apply();
    this.stage.redraw();
  }

  /// The finding that is looked at.
  private get chosen(): Finding | undefined {
    return this.state.finding === undefined ? undefined : this.findings.all[this.state.finding];
  }

  /// A page without findings that has levels shows one at once, unless a link says otherwise.
  private openLevels(): void {
    const { header } = this.data;
    const layer = header.layers.findIndex((one) => one.steps && one.steps.length > 0);
    if (layer < 0 || this.findings.all.length > 0 || location.hash.length > 1) return;
    this.state.steps.set(layer, firstStep(header.layers[layer]));
  }

  private noticeIfEmpty(): void {
    const notice = element('notice');
    notice.hidden = this.data.report.objects.length > 0 || this.data.header.time !== undefined;
    notice.textContent = 'This scene is empty: it holds no object.';
  }

  /// What the engine says of a page that is not about objects. Such a page has no lists of them.
  private tellSummary(): void {
    const { header, report } = this.data;
    if (header.summary !== undefined) element('summary').textContent = header.summary;
    element('side').hidden = header.time !== undefined && report.objects.length === 0;
  }

  /// What the link asks for in vain.
  private complain(complaints: string[]): void {
    element('complaint').hidden = complaints.length === 0;
    const text = complaints.map((complaint) => `${complaint}.`).join(' ');
    element('complaint-text').textContent = `The link to this view is not understood in all: ${text}`;
  }

  /// Where an object is, in shown coordinates.
  boxOf(object: number): Box3 {
    return this.objects.boxes[object];
  }

  private boxAround(objects: number[]): Box3 {
    return objects.reduce((box, object) => box.union(this.objects.boxes[object]), new Box3());
  }

  private colourOf(object: number): number {
    const { chosen } = this;
    if (chosen) return object === chosen.a ? objectA : object === chosen.b ? objectB : untouched;
    if (this.motion) return bodyColours[this.meeting.has(object) ? 2 : this.motion.moves(object) ? 1 : 0];
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
    if (this.motion && !this.motion.isThere(object)) return 'hidden';
    if (state.hidden.has(object) || (state.only && !state.only.has(object))) return 'hidden';
    if (state.ghosts.has(object)) return 'ghost';
    if (opened.has(object)) return 'hidden'; // its triangles are drawn in the colours of the level
    const { chosen } = this;
    if (!chosen) return opened.size > 0 ? state.rest : 'shown';
    if (!objectsOf(chosen).includes(object)) return state.rest;
    return object === chosen.outer ? 'ghost' : 'shown';
  }

  /// Everything anew from the state.
  show(): void {
    const { state } = this;
    const theme = themes[state.theme];
    document.documentElement.dataset.theme = state.theme;
    document.documentElement.dataset.panels = state.panels ? 'on' : 'off';
    document.documentElement.dataset.card = state.card ? 'on' : 'off';
    this.objects.seeThrough(state.through);
    this.placeObjects();
    const opened = this.opened();
    const looks = this.data.report.objects.map((_, i) => ({ look: this.lookOf(i, opened), colour: this.colourOf(i) }));
    if (this.chosen) this.colourContainer(looks, this.chosen);
    this.objects.show(looks, theme.ghost);
    this.stage.setTheme(theme, state.grid);
    this.layerPanel.show();
    this.stage.setOverlays([...this.overlays(), ...this.placeBoxes(), ...this.measured()]);
    this.marks.avoid = this.cornersOfPlace();
    this.marks.set([...(state.labels ? this.labels() : []), ...this.measure.marks()]);
    this.showSection();
    this.showButtons();
  }

  private shown([x, y, z]: Vec): Vector3 {
    const { centre, size } = this.data.header.frame;
    return new Vector3((x - centre[0]) / size, (y - centre[1]) / size, (z - centre[2]) / size);
  }

  private boxBetween([lower, upper]: [Vec, Vec]): Box3 {
    return new Box3(this.shown(lower), this.shown(upper));
  }

  private cornersOfPlace(): Vector3[] {
    const place = this.chosen?.place;
    return place ? cornersOf(this.boxBetween(place)) : [];
  }

  /// The size of the smaller of the objects that are chosen.
  private smallestOf(chosen: Finding): number {
    return Math.min(...objectsOf(chosen).map((object) => diagonalOf(this.objects.boxes[object])));
  }

  /// Around each place of what is chosen that would not be found without, drawn over everything.
  private placeBoxes(): Object3D[] {
    const { chosen } = this;
    if (!chosen?.place) return [];
    const places = (chosen.regions?.length ? chosen.regions : [chosen.place]).map((place) => this.boxBetween(place));
    const small = places.filter((place) => diagonalOf(place) < 0.5 * this.smallestOf(chosen));
    const ends = small.flatMap(edgesOf);
    return ends.length > 0 ? [segments(new Float32Array(ends), themes[this.state.theme].contact, 1.2, true)] : [];
  }

  private measured(): Object3D[] {
    const ends = this.measure.ends();
    return ends.length > 0 ? [segments(ends, themes[this.state.theme].distance, 2.5, true)] : [];
  }

  private showSection(): void {
    const box = this.chosen ? this.placeToFrame() : this.stage.wholeBox();
    this.stage.setSection(this.section && planeOf(this.section, box.clone().expandByScalar(1e-6)));
    element('section').hidden = this.section === undefined;
    element('cut').setAttribute('aria-pressed', String(this.section !== undefined));
    element('measure').setAttribute('aria-pressed', String(this.measure.active));
    element('measured').textContent = this.measure.text();
    if (!this.section) return;
    element<HTMLSelectElement>('section-axis').value = String(this.section.axis);
    element<HTMLInputElement>('section-at').value = String(Math.round(1000 * this.section.share));
  }

  /// Cuts through the middle of what is looked at, or no longer.
  toggleSection(): void {
    this.section = this.section ? undefined : { axis: 0, share: 0.5, flipped: false };
    this.show();
  }

  cut(change: Partial<Section>): void {
    if (this.section) this.section = { ...this.section, ...change };
    this.show();
  }

  toggleMeasure(): void {
    this.measure.toggle();
    this.show();
  }

  /// Whether the click was one that measures.
  measureAt(x: number, y: number): boolean {
    if (!this.measure.active) return false;
    const hit = this.stage.hit(x, y);
    if (hit) this.measure.add(hit.point);
    this.show();
    return true;
  }

  /// Takes over a review from the text of a file, or says what is wrong with it.
  openReview(text: string): void {
    const told = element('review-told');
    try {
      told.textContent = `${countText(this.review.read(text), 'clash', 'clashes')} of the file`;
    } catch (error) {
      told.textContent = `The file was not read: ${error instanceof Error ? error.message : String(error)}.`;
    }
    this.panels.listFindings();
  }

  saveReview(): void {
    const link = make('a');
    link.href = URL.createObjectURL(new Blob([this.review.text()], { type: 'application/json' }));
    link.download = `${this.data.header.title.replace(/[^\w.-]+/g, '-') || 'toccata'}-review.json`;
    link.click();
    this.review.changed = false;
    element('review-told').textContent = `${countText(this.review.count, 'clash', 'clashes')} in ${link.download}`;
    window.setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
  }

  /// What changes from moment to moment: the layers, and where things move these and what is found of them.
  private showMoment(): void {
    if (!this.motion) return this.stage.setOverlays(this.overlays());
    this.goToMoment();
    this.state.finding = this.sameAtThisMoment();
    this.panels.listFindings();
    this.show();
  }

  private goToMoment(): void {
    const { moment } = this.state;
    this.motion?.go(moment);
    const pairs = this.data.report.steps?.[moment]?.pairs ?? [];
    this.meeting = new Set(pairs.flatMap((pair) => (pair.in_contact && pair.change !== 'end' ? [pair.a_index, pair.b_index] : [])));
  }

  /// The finding about the two objects that are looked at, if there is one now.
  private sameAtThisMoment(): number | undefined {
    const { chosen } = this;
    if (!chosen || chosen.moment === undefined) return this.state.finding;
    const found = this.findings.all.findIndex(({ a, b, moment }) => a === chosen.a && b === chosen.b && moment === this.state.moment);
    return found < 0 ? undefined : found;
  }

  /// The ghost that contains the other one is still told by its colour.
  private colourContainer(looks: Appearance[], chosen: Finding): void {
    for (const object of objectsOf(chosen)) looks[object].ghostColour = looks[object].colour;
  }

  /// Where the chosen finding has them; else where the report has them.
  private placeObjects(): void {
    const { chosen } = this;
    if (!this.findings.all.some((finding) => finding.poses)) return;
    this.data.report.objects.forEach(({ pose }, object) => this.objects.moveTo(object, chosen?.poses?.[object] ?? pose));
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
    const found = this.data.layersOf(this.state.finding).filter((layer) => !this.state.off.has(layer.role));
    const drawn = this.state.finding === undefined ? this.overview() : found.map((layer) => this.drawn(layer));
    header.layers.forEach((layer, i) => {
      if (layer.finding !== undefined || this.state.off.has(layer.role)) return;
      const chosen = this.state.steps.get(i);
      if (layer.moments) drawn.push(...this.drawnNow(layer, layer.moments[this.state.moment]));
      else if (!layer.steps) drawn.push(this.drawn(layer));
      else if (chosen === undefined || !layer.steps[chosen]) return;
      else if (layer.kind === 'hierarchy') drawn.push(...this.drawnLevel(layer as HierarchyLayer, layer.steps[chosen]));
      else drawn.push(this.drawn(layer, layer.steps[chosen], chosen));
    });
    return drawn;
  }

  private drawnNow(layer: Layer, [first, count]: [number, number]): Object3D[] {
    return count === 0 ? [] : [this.drawn(layer, { label: '', first, count }, this.state.moment)];
  }

  /// The volumes of a level, and in the place of the object its triangles in their colours.
  private drawnLevel(layer: HierarchyLayer, step: LayerStep): Object3D[] {
    const { drawn, object, level } = drawLevel(layer, step, this.data, this.objects);
    this.levels.push(level);
    drawn.name = layer.kind;
    object.name = 'object';
    return [object, drawn];
  }

  private drawn(layer: Layer, step?: LayerStep, stepNumber = 0): Object3D {
    const size = this.focusBox().getSize(new Vector3()).length();
    const style = { theme: themes[this.state.theme], over: layer.finding !== undefined, arrow: 0.12 * size, through: this.state.through, second: this.chosen?.b, step, stepNumber };
    return draw(layer, { data: this.data, objects: this.objects }, style);
  }

  /// While none is chosen, the curves and points of all findings: one drawing each for a role; and faces in a region. Where
  /// curves of contact are too many to be told apart, and take seconds to draw, each finding is a point in the middle of them.
  private overview(): Object3D[] {
    const drawn: Object3D[] = [];
    for (const role of this.findings.shown) {
      if (this.state.off.has(role)) continue;
      const of = (kind: string) => this.data.foundOf(role, kind);
      const colour = roleColour(themes[this.state.theme], role);
      if (role === 'contact' && areManyCurves(this.data)) {
        const curves = of('segments');
        const withCurves = new Set(curves.map((layer) => layer.finding));
        const alone = of('points').filter((layer) => !withCurves.has(layer.finding));
        drawn.push(points(middles([...curves, ...alone], this.data), colour, true, 4));
        continue;
      }
      const curves = merged(of('segments'), this.data);
      const places = merged(of('points'), this.data);
      if (curves.length > 0) drawn.push(segments(curves, colour, 2.5, true));
      if (places.length > 0) drawn.push(points(places, colour, false));
      if (role === 'within') drawn.push(...of('faces').map((layer) => this.drawn(layer)));
    }
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
    const { chosen } = this;
    if (!chosen) return [];
    const top = (box: Box3) => {
      const at = box.getCenter(new Vector3());
      const up = header.up === 'z' ? 2 : 1;
      return at.setComponent(up, box.max.getComponent(up));
    };
    const marks: Mark[] = objectsOf(chosen).map((object) => {
      const side = object === chosen.a ? 'a' : 'b';
      return { at: top(this.objects.boxes[object]), text: report.objects[object].name, className: `mark ${side}`, kept: true };
    });
    for (const layer of this.data.layersOf(this.state.finding)) {
      const text = layer.length === undefined ? layer.label : bracketText(layer.lower_length === undefined ? layer.length : layer.lower_length, layer.length, report.unit);
      if (!text || this.state.off.has(layer.role)) continue;
      const ends = this.data.floats(layer.data);
      marks.push({ at: new Vector3((ends[0] + ends[3]) / 2, (ends[1] + ends[4]) / 2, (ends[2] + ends[5]) / 2), text, className: 'mark' });
    }
    return marks;
  }

  /// Around what was found; else around what is shown.
  focusBox(): Box3 {
    const { chosen } = this;
    if (!chosen) {
      const box = new Box3();
      const opened = this.opened();
      this.data.report.objects.forEach((object, i) => {
        const isOpened = opened.has(i);
        const counts = opened.size > 0 ? isOpened : this.lookOf(i, opened) !== 'hidden';
        if (counts && object.shape !== 'half-space') box.union(this.objects.boxes[i]);
      });
      if (opened.size === 0) box.union(boxOfBodies(this.data)).union(this.boxOfCells());
      return box.isEmpty() ? this.stage.wholeBox() : box;
    }
    const found = new Box3();
    for (const layer of this.data.layersOf(this.state.finding)) {
      if (layer.kind === 'faces' || layer.kind === 'arrows') continue;
      const numbers = this.data.floats(layer.data);
      for (let i = 0; i < numbers.length; i += 3) found.expandByPoint(new Vector3(numbers[i], numbers[i + 1], numbers[i + 2]));
    }
    return this.withRoom(found, chosen);
  }

  /// Around closed cells that are drawn, such as Voronoi regions, which reach beyond their objects.
  private boxOfCells(): Box3 {
    const box = new Box3();
    this.data.header.layers.forEach((layer, i) => {
      const step = layer.steps?.[this.state.steps.get(i) ?? -1];
      if (layer.kind !== 'triangles' || !step || this.state.off.has(layer.role)) return;
      const corners = this.data.floats(layer.data).subarray(9 * step.first, 9 * (step.first + step.count));
      for (let at = 0; at < corners.length; at += 3) box.expandByPoint(new Vector3().fromArray(corners, at));
    });
    return box;
  }

  /// What is tiny beside its objects is shown with some of these around it.
  private withRoom(found: Box3, chosen: Finding): Box3 {
    const boxes = objectsOf(chosen).map((object) => this.objects.boxes[object]);
    if (boxes.length === 0) return found.isEmpty() ? this.stage.wholeBox() : found;
    boxes.sort((a, b) => diagonalOf(a) - diagonalOf(b));
    const [smaller, larger] = [boxes[0], boxes[boxes.length - 1]];
    if (chosen.outer !== undefined && diagonalOf(larger) < 4 * diagonalOf(smaller)) return larger.clone();
    if (found.isEmpty()) return smaller.clone();
    const missing = 0.6 * diagonalOf(smaller) - diagonalOf(found);
    const close = missing > 0 ? found.clone().expandByScalar(missing / 2) : found;
    const all = boxes.reduce((box, other) => box.union(other), close.clone());
    const isHalfSpace = objectsOf(chosen).some((i) => this.data.report.objects[i].shape === 'half-space');
    return !isHalfSpace && diagonalOf(all) < 4 * diagonalOf(close) ? all : close;
  }

  /// The place of what is chosen with some of its objects around it, as much as tells what they are: half of what the thinner one
  /// measures across, and in proportion to the place, since a clash is looked at and not its parts.
  private placeToFrame(): Box3 {
    const { chosen } = this;
    if (!chosen?.place || !this.isCloseUp) return this.focusBox();
    const box = this.boxBetween(chosen.place);
    const thin = Math.min(...objectsOf(chosen).map((object) => thinnestOf(this.objects.boxes[object])));
    const size = diagonalOf(box);
    const room = Math.max(Math.min(0.5 * thin, 1.2 * size), 0.25 * size, 0.1 * thin, 1e-6);
    return box.expandByScalar(room).intersect(this.focusBox());
  }

  /// The larger part of the picture above or beside the card that tells of what is chosen; none where there is no card, or no
  /// room but behind it.
  private freePart(): FreePart | undefined {
    const canvas = element('canvas').getBoundingClientRect();
    const card = element('found').getBoundingClientRect();
    const { width, height } = canvas;
    if (height === 0 || card.height === 0 || card.top >= canvas.bottom) return undefined;
    const above = Math.min(width, card.top - canvas.top);
    const beside = Math.min(height, card.left - canvas.left);
    if (Math.max(above, beside) < 0.3 * Math.min(width, height)) return undefined;
    if (above >= beside) return { right: 0, up: (canvas.bottom - card.top) / (2 * height), side: above / height };
    return { right: (card.left - canvas.right) / (2 * height), up: 0, side: beside / height };
  }

  frame(): void {
    this.stage.orbit.keepClear(this.freePart());
    this.stage.frameBox(this.placeToFrame());
    const { target, distance } = this.stage.orbit.place;
    this.framed = { target: target.clone(), distance };
  }

  /// Frames what is chosen anew; where it is framed already, goes from its place to its objects, and back.
  fit(): void {
    if (this.isFramed && this.chosen?.place) this.isCloseUp = !this.isCloseUp;
    this.frame();
  }

  /// Whether nobody has moved since the last `frame`.
  private get isFramed(): boolean {
    const { target, distance } = this.stage.orbit.place;
    return this.framed !== undefined && this.framed.target.equals(target) && this.framed.distance === distance;
  }

  choose(finding: number | undefined): void {
    if (finding === undefined && this.state.finding === undefined) return;
    this.state.finding = finding;
    this.isCloseUp = true;
    this.panels.markFinding();
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
