// The palette of M. Okabe and K. Ito ("Color universal design", 2008), which people tell apart who see colours
// otherwise, and what of it means what.
import { Color } from 'three';

export const black = 0x000000;
const orange = 0xe69f00;
const skyBlue = 0x56b4e9;
const green = 0x009e73;
const blue = 0x0072b2;
const vermilion = 0xd55e00;
const purple = 0xcc79a7;

export const objectA = skyBlue;
export const objectB = orange;
export const facesA = blue;
export const facesB = vermilion;
export const untouched = 0xa9b2bb;

/// Objects that take part in a finding, while none is chosen: pale, so that what meets stands out.
const touched = [skyBlue, orange, green, purple, blue, vermilion].map((hex) => new Color(hex).lerp(new Color(0xffffff), 0.25).getHex());

export const touchedColour = (index: number) => touched[index % touched.length];

/// By the step of a layer, such as the level of a hierarchy, or by item.
export const stepColours = [blue, orange, green, purple, skyBlue, vermilion];

/// At rest, moving, moving and in a pair.
export const bodyColours = [untouched, skyBlue, orange];

/// The colours of pairs of a World that begin, and that end.
export const eventColours = { begin: vermilion, end: purple };

export interface Theme {
  background: number;
  grid: number;
  gridAxis: number;
  ghost: number;
  contact: number;
  depth: number;
  distance: number;
  normal: number;
  ray: number;
  start: number;
  asked: number;
  hit: number;
  region: number;
  within: number;
}

export const themes: Record<'light' | 'dark', Theme> = {
  light: {
    background: 0xf4f6f8,
    grid: 0xd9dee4,
    gridAxis: 0xb4bcc6,
    ghost: 0x6b7785,
    contact: 0x111418,
    depth: 0xb1005a,
    distance: 0x00664b,
    normal: 0x7a3f6b,
    ray: 0x00664b,
    start: 0x00664b,
    asked: 0x00664b,
    hit: 0xb1005a,
    region: 0x7a3f6b,
    within: facesA,
  },
  dark: {
    background: 0x14181d,
    grid: 0x262d35,
    gridAxis: 0x3d4753,
    ghost: 0x9fb0c2,
    contact: 0xffffff,
    depth: 0xff6fb0,
    distance: 0x4fe0b5,
    normal: 0xe5a9d0,
    ray: 0x4fe0b5,
    start: 0x4fe0b5,
    asked: 0x4fe0b5,
    hit: 0xff6fb0,
    region: 0xe5a9d0,
    within: facesA,
  },
};
