// Draws a scene without having the page wait for the graphics card. A browser that draws by software takes 0.2 s and
// more for a picture of a robot, and a canvas that was drawn on holds up the whole page until it is done: the stop, too.
// So a picture is drawn beside the canvas, and put on it once it is done; that takes a few milliseconds.
import * as THREE from "three";

type Size = { width: number; height: number };

export class Drawing {
  private beside: THREE.WebGLRenderTarget;
  private copy: THREE.Mesh<THREE.PlaneGeometry, THREE.MeshBasicMaterial>;
  private front = new THREE.OrthographicCamera(-1, 1, 1, -1, 0, 1);
  private done: WebGLSync | null = null;
  private size: Size = { width: 1, height: 1 };
  busy = false; // with a picture that is not on the canvas yet

  constructor(private renderer: THREE.WebGLRenderer) {
    // Four samples a pixel, as a canvas has them. Bytes of sRGB are what the canvas will have, and are encoded by the card.
    this.beside = new THREE.WebGLRenderTarget(1, 1, { samples: renderer.getPixelRatio() < 2 ? 4 : 0, colorSpace: THREE.SRGBColorSpace });
    const material = new THREE.MeshBasicMaterial({ map: this.beside.texture, depthTest: false, depthWrite: false, toneMapped: false });
    this.copy = new THREE.Mesh(new THREE.PlaneGeometry(2, 2), material);
    this.copy.frustumCulled = false;
  }

  begin(scene: THREE.Scene, camera: THREE.Camera, size: Size) {
    const ratio = this.renderer.getPixelRatio();
    this.size = size;
    this.beside.setSize(Math.floor(size.width * ratio), Math.floor(size.height * ratio));
    this.renderer.setRenderTarget(this.beside);
    this.renderer.render(scene, camera);
    this.renderer.setRenderTarget(null);
    const gl = this.renderer.getContext() as WebGL2RenderingContext;
    this.done = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    this.busy = true;
  }

  // Puts the picture on the canvas if it is done, and says whether it did.
  show(): boolean {
    if (!this.busy) return false;
    const gl = this.renderer.getContext() as WebGL2RenderingContext;
    if (this.done && gl.clientWaitSync(this.done, 0, 0) === gl.TIMEOUT_EXPIRED) return false;
    gl.deleteSync(this.done);
    this.done = null;
    this.busy = false;
    const now = this.renderer.getSize(new THREE.Vector2());
    // A canvas that changes its size is empty: it does so with the picture that fits.
    if (now.x !== this.size.width || now.y !== this.size.height) this.renderer.setSize(this.size.width, this.size.height);
    this.renderer.render(this.copy, this.front);
    return true;
  }

  close() {
    this.beside.dispose();
    this.copy.geometry.dispose();
    this.copy.material.dispose();
  }
}
