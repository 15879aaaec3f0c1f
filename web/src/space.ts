// The machine in space, to be turned: the scene of the engine as lines and balls, tension as colour.
import {
  BufferGeometry, Color, Float32BufferAttribute, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial,
  PerspectiveCamera, Scene as World, SphereGeometry, Vector3, WebGLRenderer, Box3, GridHelper, MathUtils,
} from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import { CSS2DObject, CSS2DRenderer } from 'three/examples/jsm/renderers/CSS2DRenderer.js';
import { tensionRgb } from './colour';
import { el } from './dom';
import type { Scene } from './types';

const lineOfSight = new Vector3(-0.25, -0.95, 0.45).normalize();

/** 1, 2 or 5 times a power of ten, at most a tenth of `size`. */
function gridStep(size: number): number {
  const power = 10 ** Math.floor(Math.log10(size / 10));
  return [5, 2, 1].map((k) => k * power).find((step) => step <= size / 10) ?? power;
}

export class Space {
  private renderer: WebGLRenderer;
  private names = new CSS2DRenderer();
  private world = new World();
  private camera = new PerspectiveCamera(40, 1, 0.1, 10000);
  private controls: OrbitControls;
  private scene: Scene | null = null;
  private frame = 0;
  private near = 1;
  private asked = 0;

  /** Throws where the browser has no WebGL. */
  constructor(private box: HTMLElement) {
    this.renderer = new WebGLRenderer({ antialias: true, alpha: true });
    this.names.domElement.className = 'names';
    box.append(this.renderer.domElement, this.names.domElement);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, this.renderer.domElement);
    this.controls.listenToKeyEvents(box);
    this.controls.addEventListener('change', () => this.draw());
    new ResizeObserver(() => this.draw()).observe(box);
  }

  show(scene: Scene | null, keep: boolean): void {
    this.scene = scene;
    if (!keep) this.look();
    this.build();
  }

  setFrame(frame: number): void {
    this.frame = frame;
    this.build();
  }

  private extent(): Box3 {
    const all = new Box3();
    for (const line of this.scene?.lines ?? []) {
      for (const f of line.points) {
        for (let i = 0; i + 2 < f.length; i += 3) {
          if (f[i] != null) all.expandByPoint(new Vector3(f[i]!, f[i + 1]!, f[i + 2]!));
        }
      }
    }
    for (const p of this.scene?.points ?? []) for (const at of p.at) if (at[0] != null) all.expandByPoint(new Vector3(...at));
    return all;
  }

  private look(): void {
    const all = this.extent();
    if (all.isEmpty()) return;
    const size = all.getSize(new Vector3()).length() || 1;
    this.near = size;
    all.getCenter(this.controls.target);
    this.camera.position.copy(this.controls.target).addScaledVector(lineOfSight, this.distance(all));
    this.camera.near = size / 1000;
    this.camera.far = size * 20;
    this.controls.update();
  }

  /** So far from the middle that every corner is seen, with a margin for the names. */
  private distance(all: Box3): number {
    const right = new Vector3().crossVectors(this.camera.up, lineOfSight).normalize();
    const above = new Vector3().crossVectors(lineOfSight, right);
    const rise = Math.tan(MathUtils.degToRad(this.camera.fov / 2));
    const aspect = this.box.clientWidth / Math.max(this.box.clientHeight, 1) || 1;
    let most = 0;
    for (const x of [all.min.x, all.max.x]) {
      for (const y of [all.min.y, all.max.y]) {
        for (const z of [all.min.z, all.max.z]) {
          const v = new Vector3(x, y, z).sub(this.controls.target);
          const aside = Math.max(Math.abs(v.dot(right)) / (rise * aspect), Math.abs(v.dot(above)) / rise);
          most = Math.max(most, v.dot(lineOfSight) + 1.2 * aside);
        }
      }
    }
    return most || 1;
  }

  private build(): void {
    for (const old of [...this.world.children]) {
      this.world.remove(old);
      if (old instanceof LineSegments || old instanceof Mesh) old.geometry.dispose();
      if (old instanceof CSS2DObject) old.element.remove();
    }
    const style = getComputedStyle(this.box);
    const colour = (name: string) => new Color(style.getPropertyValue(`--${name}`).trim());
    const all = this.extent();
    if (!all.isEmpty()) {
      const step = gridStep(this.near);
      const number = 2 * Math.ceil((0.7 * this.near) / step);
      const grid = new GridHelper(number * step, number, colour('line'), colour('grid'));
      grid.rotation.x = Math.PI / 2;
      const middle = all.getCenter(new Vector3());
      grid.position.set(Math.round(middle.x / step) * step, Math.round(middle.y / step) * step, all.min.z);
      this.world.add(grid);
      this.name(`grid ${step} m`, new Vector3(grid.position.x, all.min.y - step, all.min.z), 'measure');
    }
    const places: number[] = [];
    const colours: number[] = [];
    const range = this.scene?.tension ?? null;
    const plain = colour('structure');
    for (const line of this.scene?.lines ?? []) {
      const p = line.points[Math.min(this.frame, line.points.length - 1)] ?? [];
      const tension = line.tension[Math.min(this.frame, line.tension.length - 1)] ?? [];
      for (let i = 0; i + 5 < p.length; i += 3) {
        if (p[i] == null || p[i + 3] == null) continue;
        for (const k of [i, i + 3]) {
          places.push(p[k]!, p[k + 1]!, p[k + 2]!);
          const here = tension[k / 3];
          const c = here != null && range ? new Color(`rgb(${tensionRgb(here, range.least, range.most).join(',')})`) : plain;
          colours.push(c.r, c.g, c.b);
        }
      }
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new Float32BufferAttribute(places, 3));
    geometry.setAttribute('color', new Float32BufferAttribute(colours, 3));
    this.world.add(new LineSegments(geometry, new LineBasicMaterial({ vertexColors: true })));
    const named = new Set<string>();
    for (const p of this.scene?.points ?? []) {
      const at = p.at[Math.min(this.frame, p.at.length - 1)];
      if (!at || at[0] == null) continue;
      const ball = new Mesh(new SphereGeometry(Math.max(p.radius, this.near / 150), 16, 12), new MeshBasicMaterial({ color: colour('body') }));
      ball.position.set(...at);
      this.world.add(ball);
      if (!named.has(p.name)) this.name(p.name, ball.position, 'name');
      named.add(p.name);
    }
    this.draw();
  }

  /** Of names that lie on each other, as of a tower and the sheave on it, the first is read. */
  private clear(): void {
    const taken: DOMRect[] = [];
    for (const span of this.names.domElement.querySelectorAll('span')) {
      const r = span.getBoundingClientRect();
      const covered = taken.some((t) => r.left < t.right && t.left < r.right && r.top < t.bottom && t.top < r.bottom);
      span.style.visibility = covered ? 'hidden' : '';
      if (!covered) taken.push(r);
    }
  }

  private name(text: string, at: Vector3, kind: string): void {
    const label = new CSS2DObject(el('span', { class: kind }, text));
    label.center.set(0, 1);
    label.position.copy(at);
    this.world.add(label);
  }

  draw(): void {
    if (this.asked) return;
    this.asked = requestAnimationFrame(() => {
      this.asked = 0;
      const width = this.box.clientWidth;
      const height = this.box.clientHeight;
      if (width === 0 || height === 0) return;
      this.renderer.setPixelRatio(window.devicePixelRatio || 1);
      this.renderer.setSize(width, height);
      this.camera.aspect = width / height;
      this.camera.updateProjectionMatrix();
      this.renderer.render(this.world, this.camera);
      this.names.setSize(width, height);
      this.names.render(this.world, this.camera);
      this.clear();
    });
  }
}
