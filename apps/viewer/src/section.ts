// A plane that cuts away what is in front of it.
import { Box3, Plane, Vector3 } from 'three';

export interface Section {
  axis: 0 | 1 | 2;
  share: number; // of the way through what is framed
  flipped: boolean;
}

/// What is on its positive side stays.
export function planeOf({ axis, share, flipped }: Section, box: Box3): Plane {
  const [low, high] = [box.min.getComponent(axis), box.max.getComponent(axis)];
  const normal = new Vector3().setComponent(axis, flipped ? 1 : -1);
  const at = low + share * (high - low);
  return new Plane(normal, flipped ? -at : at);
}
