// Bodies once more, seen through, where the joints of an arm would bring them.
import { Group, Mesh, MeshLambertMaterial, type BufferGeometry, type Scene } from 'three'
import type { Pose } from '../geom/chain'

export class Ghosts {
  private readonly groups = new Map<number, Group>()
  private readonly material = new MeshLambertMaterial({ transparent: true, opacity: 0.42, depthWrite: false })

  constructor(
    private readonly scene: Scene,
    private readonly bodies: readonly Group[],
  ) {}

  /** These bodies stand there, and no others; red where the arm cannot go. */
  stand(poses: ReadonlyMap<number, Pose>, isBeyond: boolean): void {
    for (const [body, group] of this.groups) group.visible = poses.has(body)
    for (const [body, [x, y, z, qw, qx, qy, qz]] of poses) {
      const group = this.groups.get(body) ?? this.copy(body)
      group.visible = true
      group.position.set(x, y, z)
      group.quaternion.set(qx, qy, qz, qw)
    }
    this.material.color.set(isBeyond ? '#d03020' : '#2f7fd8')
  }

  /** Shapes have changed: bodies are copied anew when they are needed. */
  forget(): void {
    for (const ghost of this.groups.values()) ghost.removeFromParent()
    this.groups.clear()
  }

  private copy(body: number): Group {
    const ghost = new Group()
    for (const part of this.bodies[body]?.children ?? []) {
      if (!(part instanceof Mesh)) continue
      const mesh = new Mesh(part.geometry as BufferGeometry, this.material)
      mesh.position.copy(part.position)
      mesh.quaternion.copy(part.quaternion)
      mesh.scale.copy(part.scale)
      ghost.add(mesh)
    }
    this.groups.set(body, ghost)
    this.scene.add(ghost)
    return ghost
  }
}
