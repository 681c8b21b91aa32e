/// The 3-D view: camera, lights, drawing on demand.
import {
  AmbientLight,
  Box3,
  Color,
  DirectionalLight,
  Group,
  PerspectiveCamera,
  Scene,
  Vector3,
  WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

const FIELD_OF_VIEW = 28;
const MARGIN = 0.96; // of half the picture, that the tube may fill

/// Views by name: from where the camera looks, and what is up.
export const VIEWS = {
  overview: new Vector3(-0.3, 0.36, 1),
  side: new Vector3(0, 0, 1),
  above: new Vector3(0, 1, 1e-3),
  end: new Vector3(-1, 0, 1e-3),
};

export class View3D {
  constructor(place) {
    this.place = place;
    this.renderer = new WebGLRenderer({ antialias: true });
    this.renderer.setPixelRatio(Math.min(2, window.devicePixelRatio));
    this.renderer.localClippingEnabled = true;
    place.append(this.renderer.domElement);
    this.scene = new Scene();
    this.scene.background = new Color("#f6f7f9");
    this.camera = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.01, 1000);
    this.world = new Group(); // scaled so that the tube has a size of about 1
    this.scene.add(this.world, new AmbientLight("#ffffff", 1.5), this.camera);
    const lamp = new DirectionalLight("#ffffff", 1.9);
    lamp.position.set(-0.5, 1, 1);
    this.camera.add(lamp); // shines from behind the viewer's shoulder
    this.controls = new OrbitControls(this.camera, this.renderer.domElement);
    this.controls.addEventListener("change", () => this.draw());
    new ResizeObserver(() => this.resize()).observe(place);
  }

  add(object) {
    this.world.add(object);
  }

  /// Scales and centres the view to `object`.
  fit(object) {
    const box = new Box3().setFromObject(object);
    const size = box.getSize(new Vector3());
    this.world.scale.setScalar(1 / size.x);
    this.world.position.copy(box.getCenter(new Vector3())).multiplyScalar(-1 / size.x);
    const half = size.divideScalar(2 * size.x);
    this.corners = [-1, 1].flatMap((x) =>
      [-1, 1].flatMap((y) => [-1, 1].map((z) => new Vector3(x, y, z).multiply(half))),
    );
    this.resize();
    this.look("overview");
  }

  /// Looks from a direction, as near as the whole tube allows.
  look(name) {
    const from = VIEWS[name].clone().normalize();
    for (let distance = 0.2; distance < 50; distance *= 1.04) {
      this.camera.position.copy(from).multiplyScalar(distance);
      this.camera.lookAt(0, 0, 0);
      this.camera.updateMatrixWorld();
      if (this.corners.every((corner) => this.sees(corner))) break;
    }
    this.controls.target.set(0, 0, 0);
    this.controls.update();
    this.draw();
  }

  sees(corner) {
    const { x, y, z } = corner.clone().project(this.camera);
    return Math.abs(x) < MARGIN && Math.abs(y) < MARGIN && Math.abs(z) < 1;
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.place;
    if (width === 0 || height === 0) return;
    this.renderer.setSize(width, height);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  draw() {
    this.renderer.render(this.scene, this.camera);
  }
}
