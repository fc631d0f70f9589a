// A world in three dimensions, drawn by three.js: built once, then only posed. It draws when something has changed and
// at no other time.
import {
  AmbientLight,
  ArrowHelper,
  Box3,
  BufferGeometry,
  Color,
  DirectionalLight,
  DoubleSide,
  Fog,
  GridHelper,
  Group,
  HemisphereLight,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  PCFShadowMap,
  PerspectiveCamera,
  PointLight,
  Scene,
  SRGBColorSpace,
  Vector3,
  WebGLRenderer,
  type Material,
} from 'three'
import { OrbitControls } from 'three/addons/controls/OrbitControls.js'
import { inks } from '../values/inks'
import { movedBodies, posture, type Hinge, type Pose } from '../geom/chain'
import { distanceTo, FROM } from './framing'
import { Ghosts } from './ghosts'
import { Handle, type Place } from './handle'
import { Knobs } from './knobs'
import { hitUnder, placeUnder } from './picking'
import { geometryOf } from './shapeGeometry'
import { bodiesOf, GLOW, ROW, type Shape, type World } from '../values/world'

/** Nobody sees more pictures than these, and nobody sees a smaller move: 0.2 mm, or as much of a turn. */
const APART_MS = 33
const SEEN = 0.0002
/** Of its time a picture leaves so much to all else: without graphics hardware it is made by the processor that drives the arm. */
const REST = 3
/** How long the arrow at a place that is pointed at is, in m. */
const ARROW = 0.12
/** Paint of a lamp's glass. */
const BULB = 'glass'

export { dress } from './meshes'

export class WorldScene {
  readonly bodies: number
  private readonly renderer = new WebGLRenderer({ antialias: true })
  private readonly scene = new Scene()
  private readonly camera = new PerspectiveCamera(30, 1, 0.02, 60)
  private readonly controls: OrbitControls
  private readonly handle = new Handle(this.camera)
  private readonly knobs: Knobs
  private readonly groups: Group[]
  private readonly glows: Mesh[] = []
  private readonly meshes = new Map<string, Mesh[]>()
  private readonly bulbs: MeshLambertMaterial[] = []
  private readonly floors: MeshLambertMaterial[] = []
  private readonly hinges: ReadonlyMap<number, Hinge>
  private readonly ghosts: Ghosts
  private readonly grid = new GridHelper(12, 40)
  private readonly arrow = new ArrowHelper(new Vector3(0, 0, -1), new Vector3(), ARROW, '#2f7fd8', ARROW / 3, ARROW / 6)
  private readonly lights: { sky: HemisphereLight; window: DirectionalLight; lamp?: PointLight }
  private isDue = false
  private posed: Float32Array = new Float32Array()
  private isLit: boolean | undefined
  /** How long the last picture took until the next could be made, in ms. */
  private took = 0
  private began = 0
  private isViewed = false
  private isSized = false

  /** `place` is filled by the picture. Throws where the browser has no WebGL. */
  constructor(
    private readonly place: HTMLElement,
    world: World,
  ) {
    this.bodies = bodiesOf(world)
    this.hinges = new Map(world.shapes.flatMap(({ body, hinge }) => (hinge ? [[body, hinge] as const] : [])))
    this.groups = Array.from({ length: this.bodies }, () => new Group())
    this.ghosts = new Ghosts(this.scene, this.groups)
    this.arrow.visible = false
    this.knobs = new Knobs(world.buttons ?? {}, world.switches)
    this.scene.add(...this.groups, this.knobs.group, this.arrow, this.handle.ring)
    for (const shape of world.shapes) this.build(shape)
    this.lights = this.light()
    this.renderer.shadowMap.enabled = true
    this.renderer.shadowMap.type = PCFShadowMap
    this.renderer.outputColorSpace = SRGBColorSpace
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2))
    this.camera.up.set(0, 0, 1)
    this.controls = new OrbitControls(this.camera, this.renderer.domElement)
    this.controls.maxPolarAngle = Math.PI * 0.495
    this.controls.addEventListener('change', () => this.draw())
    this.controls.listenToKeyEvents(place)
    place.append(this.renderer.domElement)
    this.ground()
    this.resize()
  }

  /** Rows of x y z w x y z. The first ones also decide from where one looks. */
  pose(rows: Float32Array): void {
    if (rows.length === this.posed.length && rows.every((value, k) => Math.abs(value - this.posed[k]) < SEEN)) return
    if (!isWhole(rows)) return // a world that has not taken its first step yet
    this.posed = rows
    this.groups.forEach((group, k) => {
      const [x, y, z, qw, qx, qy, qz] = rows.subarray(k * ROW, (k + 1) * ROW)
      group.position.set(x, y, z)
      group.quaternion.set(qx, qy, qz, qw)
    })
    if (!this.isViewed) this.look()
    this.draw()
  }

  /** A second arm, seen through, where the joints of an arm would bring it; without one there is none. */
  haunt(arm: string, joints: readonly number[], isBeyond = false): void {
    const poses = this.posed.length ? posture(this.hinges, arm, joints, (body) => this.poseOf(body)) : new Map()
    this.ghosts.stand(poses as ReadonlyMap<number, Pose>, isBeyond)
    this.draw()
  }

  /** The place under a point of the window; arms are looked through, for they will stand elsewhere. */
  under(clientX: number, clientY: number): ReturnType<typeof placeUnder> {
    const moved = movedBodies(this.hinges)
    const parts = this.groups.filter((_, body) => !moved.has(body))
    return placeUnder(...this.share(clientX, clientY), this.camera, parts)
  }

  /** The button under a point of the window, if nothing stands before it. */
  buttonUnder(clientX: number, clientY: number): string | undefined {
    const parts = [this.knobs.group, ...this.groups]
    return this.knobs.of(hitUnder(...this.share(clientX, clientY), this.camera, parts)?.object)
  }

  /** These buttons are down. */
  press(pressed: readonly string[]): void {
    this.knobs.press(pressed)
    this.draw()
  }

  /** A point of the window as shares of the picture, -1 to 1, y upwards. */
  private share(clientX: number, clientY: number): [number, number] {
    const { left, top, width, height } = this.canvas.getBoundingClientRect()
    return [((clientX - left) / width) * 2 - 1, 1 - ((clientY - top) / height) * 2]
  }

  /** An arrow that ends at a place, along its normal; without one there is none. */
  mark(place?: { position: readonly [number, number, number]; normal: readonly [number, number, number] }): void {
    this.arrow.visible = place !== undefined
    if (place) {
      const normal = new Vector3(...place.normal)
      this.arrow.position.set(...place.position).addScaledVector(normal, ARROW)
      this.arrow.setDirection(normal.negate())
    }
    this.draw()
  }

  /** A ring at the tool, by which it is dragged; without a place there is none. */
  grip(place?: Place): void {
    this.handle.put(place)
    this.draw()
  }

  /** Whether a point of the window lies on that ring. */
  isGrip(clientX: number, clientY: number): boolean {
    const { left, top, width, height } = this.canvas.getBoundingClientRect()
    return this.handle.isUnder(clientX - left, clientY - top, width, height)
  }

  /** The way from the tool to a point of the window, in m; while it is dragged the view stays. */
  dragged(clientX: number, clientY: number): Place {
    this.controls.enabled = false
    const { left, top, width, height } = this.canvas.getBoundingClientRect()
    return this.handle.way(clientX - left, clientY - top, width, height)
  }

  /** The hand has let go: a drag turns the view again. */
  dropped(): void {
    this.controls.enabled = true
  }

  private poseOf(body: number): Pose {
    const [x = 0, y = 0, z = 0, w = 1, i = 0, j = 0, k = 0] = this.posed.subarray(body * ROW, (body + 1) * ROW)
    return [x, y, z, w, i, j, k]
  }

  /** In place of the boxes that stand for this mesh. */
  put(mesh: string, geometry: BufferGeometry): void {
    for (const part of this.meshes.get(mesh) ?? []) {
      part.geometry.dispose()
      part.geometry = geometry
    }
    this.ghosts.forget()
    this.draw()
  }

  /** Lamps shine or do not. */
  lit(isOn: boolean): void {
    if (isOn === this.isLit) return
    this.isLit = isOn
    for (const glow of this.glows) glow.visible = isOn
    for (const bulb of this.bulbs) bulb.emissive.set(isOn ? '#ffd469' : '#000000')
    if (this.lights.lamp) this.lights.lamp.intensity = isOn ? 0.12 : 0
    this.draw()
  }

  /** The first view again. */
  look(): void {
    this.isViewed = true
    const box = new Box3()
    for (const group of [...this.groups.slice(1), this.knobs.group]) box.expandByObject(group)
    if (box.isEmpty()) box.set(new Vector3(-1, -1, 0), new Vector3(1, 1, 1))
    const middle = box.getCenter(new Vector3())
    const narrow = Math.min(1, this.camera.aspect)
    const away = distanceTo(box, middle, Math.tan((this.camera.fov * Math.PI) / 360) * narrow)
    this.controls.target.copy(middle)
    this.camera.position.copy(middle).addScaledVector(FROM, away)
    this.controls.update()
    this.draw()
  }

  /** Colours of the page's ground; call it when that changes. */
  ground(): void {
    const tones = inks(this.place, ['--canvas', '--dot', '--line'])
    const canvas = new Color(tones['--canvas'])
    const isDark = canvas.getHSL({ h: 0, s: 0, l: 0 }).l < 0.5
    this.scene.background = canvas
    this.scene.fog = new Fog(canvas, 5, 14)
    for (const floor of this.floors) floor.color.copy(canvas)
    for (const line of [this.grid.material].flat())
      Object.assign(line, { transparent: true, opacity: isDark ? 0.5 : 0.8 })
    const dot = new Color(tones['--line'])
    const colours = this.grid.geometry.getAttribute('color')
    for (let k = 0; k < colours.count; k += 1) colours.setXYZ(k, dot.r, dot.g, dot.b)
    colours.needsUpdate = true
    this.lights.sky.intensity = isDark ? 1.1 : 1.9
    this.lights.window.intensity = isDark ? 1.6 : 1.9
    this.draw()
  }

  /** Until the next picture the last one is stretched: a canvas of another size would be empty. */
  resize(): void {
    this.isSized = false
    Object.assign(this.canvas.style, { width: '100%', height: '100%' })
    this.camera.aspect = Math.max(1, this.place.clientWidth) / Math.max(1, this.place.clientHeight)
    this.camera.updateProjectionMatrix()
    this.draw()
  }

  private size(): void {
    this.isSized = true
    this.renderer.setSize(Math.max(1, this.place.clientWidth), Math.max(1, this.place.clientHeight))
  }

  get canvas(): HTMLCanvasElement {
    return this.renderer.domElement
  }

  destroy(): void {
    this.controls.dispose()
    this.scene.traverse((part) => {
      if (!(part instanceof Mesh)) return
      ;(part.geometry as BufferGeometry).dispose()
      for (const material of [part.material as Material | Material[]].flat()) material.dispose()
    })
    this.renderer.dispose()
    this.renderer.forceContextLoss()
    this.canvas.remove()
  }

  /** Soon, and once; never more often than can be seen, and seldom where a picture takes long. */
  private draw(): void {
    if (this.isDue || !this.isViewed) return // before the first poses the camera stands where the arm does
    this.isDue = true
    const picture = (): void => {
      this.isDue = false
      const began = performance.now()
      if (!this.isSized) this.size()
      this.handle.turn()
      this.renderer.render(this.scene, this.camera)
      this.began = began
      requestAnimationFrame(() => (this.took = performance.now() - began))
    }
    const wait = this.began + Math.max(APART_MS, this.took * (1 + REST)) - performance.now()
    if (wait > 0) setTimeout(() => requestAnimationFrame(picture), wait)
    else requestAnimationFrame(picture)
  }

  private build(shape: Shape): void {
    const geometry = geometryOf(shape)
    if (!geometry) return
    const [r, g, b, opacity] = shape.rgba
    const isGlow = shape.paint === GLOW
    const colour = new Color().setRGB(r, g, b, SRGBColorSpace)
    const material = isGlow
      ? new MeshBasicMaterial({ color: colour, transparent: true, opacity: 0.22, depthWrite: false })
      : new MeshLambertMaterial({ color: colour, transparent: opacity < 1, opacity })
    const mesh = new Mesh(geometry, material)
    mesh.name = shape.name
    mesh.position.set(...shape.position)
    const [w, x, y, z] = shape.quaternion
    mesh.quaternion.set(x, y, z, w)
    mesh.castShadow = !isGlow && shape.kind !== 'plane'
    mesh.receiveShadow = !isGlow
    if (shape.kind === 'ellipsoid') mesh.scale.set(shape.size[0], shape.size[1], shape.size[2])
    if (isGlow) {
      mesh.visible = false
      this.glows.push(mesh)
    }
    if (shape.mesh) {
      this.meshes.set(shape.mesh, [...(this.meshes.get(shape.mesh) ?? []), mesh])
      material.side = DoubleSide // others' triangles may look either way
    }
    if (shape.paint === BULB && material instanceof MeshLambertMaterial) this.bulbs.push(material)
    if (shape.kind === 'plane' && material instanceof MeshLambertMaterial) this.layFloor(shape, material)
    this.groups[shape.body]?.add(mesh)
  }

  private layFloor(shape: Shape, material: MeshLambertMaterial): void {
    material.side = DoubleSide
    this.floors.push(material)
    this.grid.rotation.x = Math.PI / 2
    this.grid.position.set(shape.position[0], shape.position[1], shape.position[2] + 0.002)
    this.scene.add(this.grid)
  }

  private light(): WorldScene['lights'] {
    const sky = new HemisphereLight('#ffffff', '#cfc8ba', 1.9)
    sky.position.set(0, 0, 1)
    const window = new DirectionalLight('#fff8ec', 1.9)
    window.position.set(-1.6, -3.2, 4.2)
    window.castShadow = true
    window.shadow.mapSize.set(1024, 1024)
    window.shadow.bias = -0.0006
    window.shadow.normalBias = 0.01
    Object.assign(window.shadow.camera, { left: -2, right: 2, top: 2, bottom: -2, near: 1, far: 10 })
    this.scene.add(sky, window, new AmbientLight('#ffffff', 0.25))
    const glow = this.glows[0]
    if (!glow?.parent) return { sky, window }
    const lamp = new PointLight('#ffd469', 0, 1.2)
    lamp.position.copy(glow.position)
    glow.parent.add(lamp)
    return { sky, window, lamp }
  }
}

/** Whether every body has a direction: rows that nobody has filled yet are all zero. */
function isWhole(rows: Float32Array): boolean {
  for (let k = 0; k < rows.length; k += ROW)
    if (!rows.subarray(k + 3, k + ROW).some((value) => Math.abs(value) > SEEN)) return false
  return true
}
