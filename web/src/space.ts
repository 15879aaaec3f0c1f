// The machine in space, to be turned: the scene of the engine as lines and balls, tension as colour.
import {
  BufferGeometry, Color, Float32BufferAttribute, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial,
  PerspectiveCamera, Scene as World, SphereGeometry, Vector3, WebGLRenderer, Box3, GridHelper,
} from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import { tensionRgb } from './colour';
import type { Scene } from './types';

export class Space {
  private renderer: WebGLRenderer;
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
    box.append(this.renderer.domElement);
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
    this.camera.position.copy(this.controls.target).add(new Vector3(-0.25 * size, -0.95 * size, 0.45 * size));
    this.camera.near = size / 1000;
    this.camera.far = size * 20;
    this.controls.update();
  }

  private build(): void {
    for (const old of [...this.world.children]) {
      this.world.remove(old);
      if (old instanceof LineSegments || old instanceof Mesh) old.geometry.dispose();
    }
    const style = getComputedStyle(this.box);
    const colour = (name: string) => new Color(style.getPropertyValue(`--${name}`).trim());
    const all = this.extent();
    if (!all.isEmpty()) {
      const grid = new GridHelper(1.4 * this.near, 14, colour('line'), colour('grid'));
      grid.rotation.x = Math.PI / 2;
      grid.position.set(this.controls.target.x, this.controls.target.y, all.min.z);
      this.world.add(grid);
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
    for (const p of this.scene?.points ?? []) {
      const at = p.at[Math.min(this.frame, p.at.length - 1)];
      if (!at || at[0] == null) continue;
      const ball = new Mesh(new SphereGeometry(Math.max(p.radius, this.near / 150), 16, 12), new MeshBasicMaterial({ color: colour('body') }));
      ball.position.set(...at);
      this.world.add(ball);
    }
    this.draw();
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
    });
  }
}
