// Lines of some points' width, whose ends are round and whose edges are smooth. All of a layer are one drawing, also where they
// are seen twice: strong where nothing is before them, and faintly through what is.
import { BufferAttribute, BufferGeometry, Color, Mesh, ShaderMaterial, Vector2, Vector4, type WebGLRenderer } from 'three';

/// Half widths, in points of the screen, at the one end and at the other.
export interface StrokeStyle {
  colour: number;
  order: number; // in which layers are drawn
  hidden: number; // how strong they are behind surfaces, 0 to 1; 0: they are not seen there
}

const vertexShader = `
  attribute vec3 end;
  attribute vec3 look; // half widths at the start and at the end; how strong: 1, or less for what is seen through surfaces
  uniform vec2 size;
  varying vec2 vPlace;
  varying vec4 vLook;

  // Curves lie in creases, whose two sides rise beside them: lines come as many points nearer to the eye.
  const float nearer = 6.0;

  void main() {
    vec4 eyeStart = modelViewMatrix * vec4(position, 1.0);
    vec4 eyeEnd = modelViewMatrix * vec4(end, 1.0);
    float near = projectionMatrix[3][2] / (1.0 - projectionMatrix[2][2]); // negative, as all that is before the eye
    if (eyeStart.z > near && eyeEnd.z > near) {
      gl_Position = vec4(2.0, 2.0, 2.0, 1.0); // outside
      return;
    }
    if (eyeStart.z > near) eyeStart = mix(eyeEnd, eyeStart, (near - eyeEnd.z) / (eyeStart.z - eyeEnd.z));
    if (eyeEnd.z > near) eyeEnd = mix(eyeStart, eyeEnd, (near - eyeStart.z) / (eyeEnd.z - eyeStart.z));
    vec4 clipStart = projectionMatrix * eyeStart;
    vec4 clipEnd = projectionMatrix * eyeEnd;
    vec2 start = 0.5 * size * clipStart.xy / clipStart.w;
    vec2 way = 0.5 * size * clipEnd.xy / clipEnd.w - start;
    float along = length(way);
    vec2 forward = along > 1e-4 ? way / along : vec2(1.0, 0.0);
    float reach = max(look.x, look.y) + 1.0;
    bool atEnd = (gl_VertexID & 2) != 0;
    vPlace = vec2(atEnd ? along + reach : -reach, (gl_VertexID & 1) != 0 ? reach : -reach);
    vLook = vec4(look, along);
    vec2 place = start + vPlace.x * forward + vPlace.y * vec2(-forward.y, forward.x);
    float z = (atEnd ? eyeEnd.z : eyeStart.z) * (1.0 - nearer * 2.0 / (projectionMatrix[1][1] * size.y));
    float depth = look.z < 1.0 ? -0.9999 : max(-0.9999, -projectionMatrix[2][2] - projectionMatrix[3][2] / z);
    gl_Position = vec4(2.0 * place / size, depth, 1.0); // w is 1: all is linear on the screen
  }`;

const fragmentShader = `
  uniform vec3 colour;
  varying vec2 vPlace;
  varying vec4 vLook;

  void main() {
    float at = clamp(vPlace.x, 0.0, vLook.w);
    float wide = mix(vLook.x, vLook.y, at / max(vLook.w, 1e-4));
    float outside = length(vec2(vPlace.x - at, vPlace.y)) - wide;
    // An arrow's head is flat, and so are ends of what is faint: round ones would be dark where two lie over each other.
    if (vLook.x > vLook.y || vLook.z < 1.0) outside = max(outside, max(-vPlace.x, vPlace.x - vLook.w));
    float cover = clamp(0.5 - outside / fwidth(vPlace.y), 0.0, 1.0);
    if (cover == 0.0) discard;
    gl_FragColor = vec4(colour, vLook.z * cover);
    #include <colorspace_fragment>
  }`;

/// The four corners of each stroke hold the same; the shader tells them apart by their numbers.
class StrokeGeometry {
  private readonly starts: Float32Array;
  private readonly ends: Float32Array;
  private readonly looks: Float32Array;
  private readonly index: Uint32Array;
  private count = 0;

  constructor(most: number) {
    this.starts = new Float32Array(12 * most);
    this.ends = new Float32Array(12 * most);
    this.looks = new Float32Array(12 * most);
    this.index = new Uint32Array(6 * most);
  }

  add(numbers: Float32Array, at: number, look: number[]): void {
    const first = 4 * this.count;
    for (let corner = first; corner < first + 4; ++corner)
      for (let axis = 0; axis < 3; ++axis) {
        this.starts[3 * corner + axis] = numbers[at + axis];
        this.ends[3 * corner + axis] = numbers[at + 3 + axis];
        this.looks[3 * corner + axis] = look[axis];
      }
    this.index.set([first, first + 2, first + 1, first + 1, first + 2, first + 3], 6 * this.count++);
  }

  take(): BufferGeometry {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(this.starts, 3));
    geometry.setAttribute('end', new BufferAttribute(this.ends, 3));
    geometry.setAttribute('look', new BufferAttribute(this.looks, 3));
    return geometry.setIndex(new BufferAttribute(this.index, 1));
  }
}

/// Numbers are six a stroke, its start and its end; `halfWidths` are of the strokes in turn.
function drawing(numbers: Float32Array, halfWidths: [number, number][], { colour, order, hidden }: StrokeStyle): Mesh {
  const strengths = hidden > 0 ? [hidden, 1] : [1]; // what is faint comes first, and the rest over it
  const geometry = new StrokeGeometry((strengths.length * numbers.length) / 6);
  for (const strength of strengths)
    for (let at = 0; at < numbers.length; at += 6) geometry.add(numbers, at, [...halfWidths[(at / 6) % halfWidths.length], strength]);
  const uniforms = { colour: { value: new Color(colour) }, size: { value: new Vector2(1, 1) } };
  const material = new ShaderMaterial({ vertexShader, fragmentShader, uniforms, transparent: true, depthWrite: false });
  const drawn = new Mesh(geometry.take(), material);
  const view = new Vector4();
  drawn.onBeforeRender = (renderer: WebGLRenderer) => {
    renderer.getViewport(view);
    uniforms.size.value.set(view.z, view.w);
    material.uniformsNeedUpdate = true;
  };
  drawn.raycast = () => {};
  drawn.frustumCulled = false;
  drawn.renderOrder = order;
  return drawn;
}

export function strokes(numbers: Float32Array, width: number, style: StrokeStyle): Mesh {
  return drawing(numbers, [[width / 2, width / 2]], style);
}

const shaft = 1.25;
const head = { width: 5.5, begins: 0.74 };

/// Numbers are six an arrow, a point and a direction of length 1.
export function arrows(numbers: Float32Array, length: number, style: StrokeStyle): Mesh {
  const ends = new Float32Array(2 * numbers.length);
  for (let i = 0; i < numbers.length; i += 6)
    for (let axis = 0; axis < 3; ++axis) {
      const at = (share: number) => numbers[i + axis] + share * length * numbers[i + 3 + axis];
      ends.set([at(0)], 2 * i + axis);
      ends.set([at(head.begins)], 2 * i + 3 + axis);
      ends.set([at(head.begins)], 2 * i + 6 + axis);
      ends.set([at(1)], 2 * i + 9 + axis);
    }
  return drawing(ends, [[shaft, shaft], [head.width, 0]], style);
}
