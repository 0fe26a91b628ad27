// The box that switches layers on and off, and slides through the steps of those that have some.
import type { Layer, PageData } from './data';
import { bodyColours, themes } from './colours';
import type { Findings } from './findings';
import { areManyCurves, roleColour } from './layers';
import { colourOfClass } from './moving';
import { element, make } from './panels';
import type { State } from './state';

/// What the roles of layers of findings are called.
const roleNames: Record<string, string> = {
  contact: 'Where they meet',
  depth: 'Depth',
  distance: 'Distance',
  normal: 'Normals',
  ray: 'Rays',
  start: 'Starts',
  asked: 'Points asked about',
  hit: 'What is met',
  region: 'Region',
  within: 'Faces in it',
  boundary_edges: 'Open edges',
  non_manifold_edges: 'Non-manifold edges',
  flipped_edges: 'Flipped edges',
  degenerate_triangles: 'Degenerate triangles',
  duplicate_triangles: 'Duplicate triangles',
  unused_vertices: 'Unused vertices',
  tree: 'Boxes of the tree',
};

export class LayerPanel {
  constructor(
    private readonly data: PageData,
    private readonly findings: Findings,
    private readonly state: State,
    private readonly changed: () => void,
  ) {}

  show(): void {
    const panel = element('layers');
    const { finding } = this.state;
    if (panel.contains(document.activeElement) && panel.dataset.finding === String(finding)) return;
    panel.dataset.finding = String(finding);
    const { layers } = this.data.header;
    const always = layers.filter((layer) => layer.finding === undefined && !layer.steps && !layer.moments);
    const found = finding === undefined ? this.data.foundRoles.filter((role) => this.findings.shown.includes(role)) : this.data.layersOf(finding).map((layer) => layer.role);
    const roles = [...new Set([...found, ...always.map((layer) => layer.role)])];
    panel.replaceChildren(...roles.map((role) => this.roleSwitch(role, undefined, finding === undefined && role === 'contact' && areManyCurves(this.data))));
    for (const layer of layers) if (layer.moments && layer.finding === undefined) panel.append(this.roleSwitch(layer.role, layer.name), ...this.classes(layer));
    if (this.data.header.motion) panel.append(this.bodyKey());
    layers.forEach((layer, i) => {
      const isMeant = finding === undefined || layer.object === undefined || this.isOf(layer.object, finding);
      if (layer.steps && layer.steps.length > 0 && isMeant) panel.append(this.stepSlider(layer, layer.steps.length, i));
    });
  }

  private isOf(object: number, finding: number): boolean {
    const { a, b } = this.findings.all[finding];
    return object === a || object === b;
  }

  /// What the colours of a layer's boxes mean, where there are several.
  private classes(layer: Layer): HTMLElement[] {
    if (!layer.classes || layer.classes.length < 2) return [];
    const list = make('ul', '', 'classes');
    list.append(
      ...layer.classes.map((name, i) => {
        const item = make('li');
        item.append(this.key(colourOfClass(layer, i)), name);
        return item;
      }),
    );
    return [list];
  }

  /// What the colours of bodies that move mean.
  private bodyKey(): HTMLElement {
    const list = make('ul', '', 'classes');
    ['at rest', 'moving', 'in contact'].forEach((name, i) => {
      const item = make('li');
      item.append(this.key(bodyColours[i]), name);
      list.append(item);
    });
    return list;
  }

  private key(colour: number): HTMLElement {
    const key = make('i');
    key.style.background = `#${colour.toString(16).padStart(6, '0')}`;
    return key;
  }

  private roleSwitch(role: string, name?: string, isPoints = false): HTMLElement {
    const label = make('label');
    const box = make('input');
    box.type = 'checkbox';
    box.checked = !this.state.off.has(role);
    box.onchange = () => {
      if (box.checked) this.state.off.delete(role);
      else this.state.off.add(role);
      this.changed();
    };
    label.append(box, this.key(roleColour(themes[this.state.theme], role)), `${roleNames[role] ?? name ?? role}${isPoints ? ', a point each' : ''}`);
    return label;
  }

  private stepSlider(layer: Layer, count: number, index: number): HTMLElement {
    const whole = make('div');
    const name = make('label', layer.name ?? layer.role);
    const slider = make('input');
    slider.type = 'range';
    slider.min = '-1';
    slider.max = String(count - 1);
    slider.value = String(this.state.steps.get(index) ?? -1);
    slider.setAttribute('aria-label', layer.name ?? layer.role);
    const tell = make('output');
    const say = () => {
      const step = layer.steps?.[Number(slider.value)];
      tell.textContent = step ? `${step.label}${step.note ? `: ${step.note}` : ''}` : 'not shown';
    };
    slider.oninput = () => {
      const step = Number(slider.value);
      if (step < 0) this.state.steps.delete(index);
      else this.state.steps.set(index, step);
      say();
      this.changed();
    };
    say();
    whole.append(name, slider, tell, ...this.classes(layer));
    return whole;
  }
}
