// The scene follows the document; what is under the pointer follows the pointer.
import { beforeEach, describe, expect, test } from 'vitest'
import type { DocumentView, TaskView } from '../../src/api.gen'
import { hanging } from '../../src/scene/hanging'
import { isOnCanvas, KINDS, nameLines, Scene, type Shown } from '../../src/scene/scene.svelte'

const pins = (kind: 'VAR' | 'CONST', reads: string[], writes: string[]): TaskView['pins'] => [
  ...reads.map((svar, k) => ({ name: `I${k}`, svar, kind: `IN${kind}` as const, y: 55 + 18 * k })),
  ...writes.map((svar, k) => ({ name: `O${k}`, svar, kind: `OUT${kind}` as const, y: 55 + 18 * k })),
]
const task = (name: string, own: TaskView['pins']): TaskView => ({
  name,
  module: name,
  library: 'g',
  order: 0,
  description: '',
  width: 136,
  height: 104,
  pins: own,
})
const ALL: Shown = { kinds: new Set(KINDS), constants: false, opened: new Set() }

let tasks: Record<string, TaskView>
let doc: DocumentView
let scene: Scene

beforeEach(() => {
  tasks = {
    arm: task('arm', [
      ...pins('VAR', ['TAU'], ['Q']),
      ...pins('CONST', [], ['DOF']).map((pin) => ({ ...pin, name: 'C', y: 73 })),
    ]),
    pd: task('pd', pins('VAR', ['Q'], ['TAU'])),
  }
  doc = {
    name: 'd',
    order: 1,
    tasks: { arm: { x: 400, y: 100 }, pd: { x: 100, y: 100 } },
    loci: {
      Q: { x: 320, y: 260, writers: ['arm'] },
      TAU: { x: 320, y: 155, writers: ['pd'] },
      DOF: { x: 600, y: 173, is_constant: true, writers: ['arm'] },
    },
  }
  scene = new Scene('d1')
  scene.follow(doc, tasks, ALL)
})

const ends = (svar: string): number => (scene.nets.get(svar)?.d.match(/M/g) ?? []).length

describe('following a document', () => {
  test('pins of one name connect by themselves, through their locus', () => {
    // R-C09
    expect([...scene.nets.keys()]).toEqual(['Q', 'TAU'])
    expect(ends('Q')).toBe(2)
    expect(scene.nets.get('Q')!.d).toContain('L320 260')
  })

  test('constants stand aside until they are asked for', () => {
    expect(scene.dots.has('DOF')).toBe(false)
    scene.follow(doc, tasks, { ...ALL, opened: new Set(['DOF']) })
    expect(ends('DOF')).toBe(1)
    scene.follow(doc, tasks, ALL)
    expect(scene.nets.has('DOF')).toBe(false)
  })

  test('a constant whose lines the document hides stays aside even then', () => {
    expect(isOnCanvas('DOF', { is_constant: true, is_shown: false }, { ...ALL, constants: true })).toBe(false)
    expect(isOnCanvas('DOF', { is_constant: true }, { ...ALL, constants: true })).toBe(true)
  })

  test('hidden connections leave the dot and its name', () => {
    // R-C09
    doc.loci!.Q!.is_shown = false
    scene.follow(doc, tasks, ALL)
    expect(scene.dots.has('Q')).toBe(true)
    expect(ends('Q')).toBe(0)
  })

  test('kinds that the user does not want are not drawn', () => {
    // R-G01
    scene.follow(doc, tasks, { ...ALL, kinds: new Set(['show_invar']) })
    expect(ends('Q')).toBe(1)
  })

  test('what was removed is gone, with its lines', () => {
    delete doc.tasks!.pd
    delete doc.loci!.TAU
    scene.follow(doc, tasks, ALL)
    expect([...scene.boxes.keys()]).toEqual(['arm'])
    expect(ends('Q')).toBe(1)
    expect(scene.nets.has('TAU')).toBe(false)
  })

  test('a pin that gets another name changes nets at once', () => {
    // R-C04
    tasks.pd = task('pd', pins('VAR', ['Q'], ['Q']))
    scene.follow(doc, tasks, ALL)
    expect(ends('Q')).toBe(3)
    expect(ends('TAU')).toBe(1)
  })

  test('a flipped box has its lines on the other side', () => {
    // R-C10
    const before = scene.nets.get('TAU')!.d
    doc.tasks!.pd!.in_left = false
    scene.follow(doc, tasks, ALL)
    expect(scene.nets.get('TAU')!.d).not.toBe(before)
  })

  test('a task that no library knows is a box without pins', () => {
    doc.tasks!.gone = { x: 0, y: 400, is_missing: true }
    scene.follow(doc, tasks, ALL)
    expect(scene.boxes.get('gone')).toMatchObject({ width: 136, pins: [] })
  })

  test('the same document again draws nothing anew', () => {
    // R-G07
    const before = [...scene.nets.values()].map((net) => net.d)
    scene.follow(structuredClone(doc), tasks, ALL)
    expect([...scene.nets.values()].map((net) => net.d)).toEqual(before)
    expect(scene.wires.takeChanged().size).toBe(0)
  })
})

describe('what is held', () => {
  test('stays under the pointer while the document changes elsewhere, and returns to the document when let go', () => {
    const box = scene.boxes.get('pd')!
    box.isHeld = true
    scene.hold('pd', 150, 300)
    doc.tasks!.arm!.x = 500
    scene.follow(doc, tasks, ALL)
    expect([box.x, box.y]).toEqual([150, 300])
    box.isHeld = false
    scene.follow(doc, tasks, ALL)
    expect([box.x, box.y]).toEqual([100, 100])
    expect(scene.nets.get('TAU')!.d).toContain('M236 155')
  })

  test('takes its lines along', () => {
    scene.boxes.get('pd')!.isHeld = true
    scene.hold('pd', 100, 400)
    scene.redraw()
    expect(scene.nets.get('TAU')!.d).toContain('M236 455')
  })

  test('a dot takes its lines along, and the boxes stay', () => {
    // R-C24
    scene.holdDot('TAU', 300, 300)
    scene.redraw()
    expect(scene.nets.get('TAU')!.d).toContain('L300 300')
    expect(scene.boxes.get('pd')!.rect).toMatchObject({ x: 100, y: 100 })
  })
})

describe('what stands where', () => {
  test('names of variables cover neither boxes nor each other', () => {
    scene.nameDots()
    const { label, x, y } = scene.dots.get('TAU')!
    expect([label.anchor, x + label.dx, y + label.dy < 155 - 5 || y + label.dy > 155 + 10]).toEqual([
      'middle',
      320,
      true,
    ])
  })

  test('the bounds hold all boxes, or those named', () => {
    expect(scene.bounds()).toEqual({ x: 100, y: 100, w: 436, h: 104 })
    expect(scene.bounds(['pd'])).toEqual({ x: 100, y: 100, w: 136, h: 104 })
    expect(scene.bounds([])).toBeUndefined()
    expect(scene.boxesIn({ x0: 0, y0: 0, x1: 120, y1: 120 }).map((box) => box.name)).toEqual(['pd'])
  })

  test('inputs that nobody supplies are counted', () => {
    // R-C08, Equation (6)
    expect(hanging(scene, doc)).toBe(0)
    doc.loci!.Q!.writers = []
    expect(hanging(scene, doc)).toBe(1)
  })
})

test.each([
  ['jtraj', 12, ['jtraj']],
  ['joint_measure_x', 15, ['joint_measure_x']],
  ['joint_measure_x', 12, ['joint_', 'measure_x']],
  ['measurementofx', 10, ['measuremen', 'tofx']],
  ['a_very_long_name_of_a_task', 12, ['a_very_long_', 'name_of_a_task']],
])('the name %s in lines of %d signs is %j (G01)', (name, longest, lines) =>
  expect(nameLines(name, longest)).toEqual(lines),
)
