// The tree of the objects: which node of the scene holds which, and the rows in which that is listed.
import type { PageData } from './data';
import type { State } from './state';

/// A line of the list: an object, or a node with all objects under it.
export interface Row {
  key: string;
  name: string;
  depth: number;
  objects: number[];
  node?: number;
}

interface Branch {
  children: number[];
  own: number[]; // objects that it carries itself
  all: number[]; // and those of the nodes under it
}

export const isDim = (state: State, object: number) => state.hidden.has(object) || (state.only !== undefined && !state.only.has(object));

/// Whether what can be chosen for objects is chosen for all of these; `only`, whether it is for them and no other.
export function isSetFor(state: State, objects: number[], what: 'hidden' | 'ghosts' | 'only'): boolean {
  const chosen = state[what];
  if (!chosen || (what === 'only' && chosen.size !== objects.length)) return false;
  return objects.every((object) => chosen.has(object));
}

export class Tree {
  readonly folded = new Set<number>();
  private readonly branches: Branch[];
  private readonly loose: number[] = [];
  private readonly roots: number[] = [];

  constructor(private readonly data: PageData) {
    const { objects, nodes = [] } = data.header;
    this.branches = nodes.map(() => ({ children: [], own: [], all: [] }));
    objects.forEach(({ node }, object) => (node === undefined ? this.loose : this.branches[node].own).push(object));
    nodes.forEach(({ parent }, node) => (parent === undefined ? this.roots : this.branches[parent].children).push(node));
    for (let node = nodes.length - 1; node >= 0; --node) {
      const { own, children } = this.branches[node]; // children come later than their parents
      this.branches[node].all = [...own, ...children.flatMap((child) => this.branches[child].all)];
    }
  }

  /// What is to be listed: objects that are called so, or are under a node that is, and the nodes above them.
  rows(wanted: string): Row[] {
    const rows: Row[] = [];
    const { nodes = [] } = this.data.header;
    const isWanted = (name: string) => name.toLowerCase().includes(wanted);
    const addObject = (object: number, depth: number, always: boolean) => {
      const { name } = this.data.report.objects[object];
      if (always || isWanted(name)) rows.push({ key: `object ${object}`, name, depth, objects: [object] });
    };
    const open: { node: number; depth: number; always: boolean }[] = [];
    const addNodes = (list: number[], depth: number, always: boolean) => {
      for (const node of [...list].reverse()) open.push({ node, depth, always });
    };
    for (const object of this.loose) addObject(object, 0, false);
    addNodes(this.roots, 0, false);
    for (let visit = open.pop(); visit; visit = open.pop()) {
      const { own, children, all } = this.branches[visit.node];
      const { depth } = visit;
      if (all.length === 0) continue;
      if (all.length === own.length && own.length === 1) {
        addObject(own[0], depth, visit.always);
        continue;
      }
      const always = visit.always || isWanted(nodes[visit.node].name);
      const found = always ? all : all.filter((object) => isWanted(this.data.report.objects[object].name));
      if (!always && found.length === 0 && !this.isNodeWanted(visit.node, isWanted)) continue;
      rows.push({ key: `node ${visit.node}`, name: nodes[visit.node].name, depth, objects: all, node: visit.node });
      if (this.folded.has(visit.node) && wanted === '') continue;
      for (const object of own) addObject(object, depth + 1, always);
      addNodes(children, depth + 1, always);
    }
    return rows;
  }

  /// Whether a node under it is called so.
  private isNodeWanted(node: number, isWanted: (name: string) => boolean): boolean {
    const { nodes = [] } = this.data.header;
    const open = [...this.branches[node].children];
    for (let at = open.pop(); at !== undefined; at = open.pop()) {
      if (this.branches[at].all.length > 0 && isWanted(nodes[at].name)) return true;
      open.push(...this.branches[at].children);
    }
    return false;
  }
}
