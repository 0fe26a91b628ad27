// The box that switches layers on and off, and slides through the steps of those that have some.
import type { Layer, PageData } from './data';
import { themes } from './colours';
import type { Findings } from './findings';
import { roleColour } from './layers';
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
    const isShown = (layer: Layer) => (finding === undefined ? this.findings.shown.includes(layer.role) : layer.finding === finding);
    const shown = layers.filter((layer) => (layer.finding === undefined ? !layer.steps : isShown(layer)));
    const roles = [...new Set(shown.map((layer) => layer.role))];
    panel.replaceChildren(...roles.map((role) => this.roleSwitch(role)));
    layers.forEach((layer, i) => {
      const isMeant = finding === undefined || layer.object === undefined || this.isOf(layer.object, finding);
      if (layer.steps && layer.steps.length > 0 && isMeant) panel.append(this.stepSlider(layer, layer.steps.length, i));
    });
  }

  private isOf(object: number, finding: number): boolean {
    const { a, b } = this.findings.all[finding];
    return object === a || object === b;
  }

  private roleSwitch(role: string): HTMLElement {
    const label = make('label');
    const box = make('input');
    box.type = 'checkbox';
    box.checked = !this.state.off.has(role);
    box.onchange = () => {
      if (box.checked) this.state.off.delete(role);
      else this.state.off.add(role);
      this.changed();
    };
    const colour = roleColour(themes[this.state.theme], role);
    const key = make('i');
    key.style.background = `#${colour.toString(16).padStart(6, '0')}`;
    label.append(box, key, roleNames[role] ?? role);
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
    whole.append(name, slider, tell);
    return whole;
  }
}
