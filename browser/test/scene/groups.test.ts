// Supermodules on the canvas: what is drawn of them, and what hand and keys do to them.
import { beforeEach, describe, expect, test, vi } from 'vitest'
import type { AnyAct, DocumentView, PlacedView } from '../../src/api.gen'

const sent = vi.hoisted(() => {
  vi.stubGlobal('navigator', { language: 'en' })
  vi.stubGlobal('Element', class {})
  return [] as AnyAct[]
})
vi.mock('../../src/link/link', () => ({
  send: (act: AnyAct) => (act.t === 'Note' || sent.push(act), Promise.resolve(null)),
}))

const { desk, fullTree } = await import('../../src/link/desk.svelte')
const { canvas, pick } = await import('../../src/state/canvas.svelte')
const { dialogs } = await import('../../src/state/dialogs.svelte')
const { nudge } = await import('../../src/scene/acts')
const { askForName, insert, openInsert, ungroup } = await import('../../src/group/grouping')
const { earlier, frameOf, freeName, groupOf, groupsIn, isAllOn, ownLoci, summary, whole } =
  await import('../../src/scene/groups')
const { PointerGestures } = await import('../../src/canvas/pointer')
const { menuOf } = await import('../../src/canvas/menu')
const { KINDS } = await import('../../src/scene/scene.svelte')
const { canvasState } = await import('../../src/scene/canvasState.svelte')

type State = NonNullable<PlacedView['state']>
const inStates = (...states: State[]): DocumentView => ({
  name: 'd',
  order: 1,
  groups: { arm: { tasks: states.map((_, k) => `t${k}`) } },
  tasks: Object.fromEntries(states.map((state, k) => [`t${k}`, { x: 0, y: 0, state }])),
})
const look = (...states: State[]): string => summary(inStates(...states), 'arm').look

describe('the state of a supermodule in one mark', () => {
  // R-C17
  test('is ON where all are, OFF where none is, and partly between', () => {
    expect([look('ON', 'ON'), look('OFF', 'OFF'), look('ON', 'OFF')]).toEqual(['ON', 'OFF', 'PARTLY'])
  })

  test('is that of whoever needs somebody, an error first', () => {
    expect([look('ON', 'ASKING', 'ERROR'), look('ON', 'ASKING', 'WAITING'), look('SPAWNING', 'ON')]).toEqual([
      'ERROR',
      'ASKING',
      'WAITING',
    ])
  })

  test('is none while nothing is connected', () => {
    expect(summary(inStates('', ''), 'arm')).toEqual({ look: '', on: 0, of: 2 })
  })

  test('counts those that are ON', () => {
    expect([
      summary(inStates('ON', 'OFF', 'ON'), 'arm'),
      isAllOn(inStates('ON'), 'arm'),
      isAllOn(inStates('ON', 'ERROR'), 'arm'),
    ]).toEqual([{ look: 'PARTLY', on: 2, of: 3 }, true, false])
  })
})

describe('what belongs together', () => {
  // R-C17
  const doc: DocumentView = {
    name: 'd',
    order: 1,
    groups: { arm: { tasks: ['pd', 'sum'] }, rest: { tasks: ['led'] } },
    loci: {
      TAU: { x: 0, y: 0, writers: ['pd'], readers: ['sum'] },
      Q: { x: 0, y: 0, writers: ['puma'], readers: ['pd'] },
      OUT: { x: 0, y: 0, writers: ['sum'], readers: [] },
      DEAD: { x: 0, y: 0 },
    },
  }

  test('a task stands for all that are one with it, in their order', () => {
    expect([whole(doc, ['sum', 'puma']), whole(doc, ['puma']), groupOf(doc, 'puma'), groupOf(doc, 'led')]).toEqual([
      ['pd', 'sum', 'puma'],
      ['puma'],
      '',
      'rest',
    ])
  })

  test('a supermodule is among tasks where all of it is', () => {
    expect([groupsIn(doc, ['pd']), groupsIn(doc, ['sum', 'pd', 'puma']), groupsIn(doc, ['led', 'pd', 'sum'])]).toEqual([
      [],
      ['arm'],
      ['arm', 'rest'],
    ])
  })

  test('a locus belongs to it where nobody else speaks or listens there', () => {
    expect(ownLoci(doc, 'arm')).toEqual(['TAU', 'OUT'])
  })

  test('the frame stands 12 px outside of the boxes', () => {
    expect(frameOf({ x: 100, y: 50, w: 200, h: 80 })).toEqual({ x: 88, y: 38, w: 224, h: 104 })
  })
})

test('the name that is proposed is nobody else’s', () => {
  // R-C17
  expect([freeName('super', []), freeName('super', ['super1', 'super2', 'x'])]).toEqual(['super1', 'super3'])
})

test('a task comes one place earlier, the first stays', () => {
  // R-C17
  expect([earlier(['a', 'b', 'c'], 2), earlier(['a', 'b'], 0)]).toEqual([
    ['a', 'c', 'b'],
    ['a', 'b'],
  ])
})

/** Something on the canvas that a pointer may be over. */
class Thing extends (Element as unknown as new () => object) {
  constructor(readonly dataset: Record<string, string>) {
    super()
  }

  closest(): Thing | null {
    return Object.keys(this.dataset).length ? this : null
  }
}
const PD = new Thing({ task: 'pd' })
const TAB = new Thing({ group: 'balance' })
const GROUND = new Thing({})

const hand = new PointerGestures()
const event = (target: Thing, more: Partial<PointerEvent> = {}): PointerEvent =>
  ({
    target,
    clientX: 120,
    clientY: 120,
    button: 0,
    pointerId: 1,
    pointerType: 'mouse',
    preventDefault: () => undefined,
    ...more,
  }) as unknown as PointerEvent

function click(target: Thing, more: Partial<PointerEvent> = {}): void {
  hand.down(event(target, more))
  hand.up(event(target, more))
}
function drag(target: Thing, dx: number, dy: number, more: Partial<PointerEvent> = {}): void {
  hand.down(event(target, more))
  hand.move(event(target, { ...more, clientX: 120 + dx, clientY: 120 + dy }))
  hand.up(event(target, { ...more, clientX: 120 + dx, clientY: 120 + dy }))
}
const labels = (): string[] => menuOf(canvasState.opened)?.items.map(({ label }) => label) ?? []
function choose(label: string): void {
  const item = menuOf(canvasState.opened)!.items.find((one) => one.label === label)!
  canvasState.close()
  item.run()
}

beforeEach(() => {
  vi.stubGlobal('document', { elementFromPoint: () => null })
  const task = (name: string) => ({
    name,
    module: name,
    library: 'g',
    order: 0,
    description: '',
    width: 136,
    height: 86,
    pins: [],
  })
  const tasks = Object.fromEntries(['pd', 'sum', 'puma'].map((name) => [name, task(name)]))
  desk.tree = fullTree({
    tasks,
    documents: {
      d1: {
        name: 'd',
        order: 1,
        connection: 'live',
        groups: { balance: { tasks: ['sum', 'pd'] } },
        tasks: {
          pd: { x: 100, y: 100, state: 'ON' },
          sum: { x: 400, y: 300, state: 'OFF' },
          puma: { x: 700, y: 500, state: 'ON' },
        },
        loci: {
          TAU: { x: 300, y: 200, writers: ['pd'], readers: ['sum'] },
          Q: { x: 600, y: 400, writers: ['puma'], readers: ['pd'] },
        },
      },
    },
  })
  canvas.doc = 'd1'
  canvas.libraryTask = ''
  dialogs.current = { name: '', data: {} }
  pick()
  canvasState.show('d1')
  Object.assign(canvasState.view, { left: 0, top: 0, seen: { x: 0, y: 0, scale: 1 }, size: { w: 900, h: 700 } })
  canvasState.scene.follow(desk.tree.documents.d1!, desk.tree.tasks, {
    kinds: new Set(KINDS),
    constants: true,
    opened: new Set(),
  })
  canvasState.pointer = undefined
  sent.length = 0
})

describe('the hand on a supermodule', () => {
  // R-C17
  test('a click on a member selects all members, with Alt only the one', () => {
    click(PD)
    const all = [...canvas.picked]
    click(PD, { altKey: true })
    expect([all, [...canvas.picked]]).toEqual([['sum', 'pd'], ['pd']])
  })

  test('a click on the tab selects all members, and puts the keyboard there', () => {
    pick('puma')
    click(TAB)
    expect([[...canvas.picked], canvasState.focus, sent]).toEqual([['sum', 'pd'], 'group:balance', []])
  })

  test('Ctrl adds the whole of it, and takes the whole away', () => {
    pick('puma')
    click(TAB, { ctrlKey: true })
    const added = [...canvas.picked]
    click(PD, { ctrlKey: true })
    expect([added, [...canvas.picked]]).toEqual([['puma', 'sum', 'pd'], ['puma']])
  })

  test('dragging a member or the tab moves all, and the dots that are theirs alone', () => {
    const moved = { t: 'Move', doc: 'd1', tasks: { sum: [450, 350], pd: [150, 150] }, loci: { TAU: [350, 250] } }
    drag(PD, 50, 50)
    canvasState.scene.hold('pd', 100, 100)
    canvasState.scene.hold('sum', 400, 300)
    canvasState.scene.holdDot('TAU', 300, 200)
    drag(TAB, 50, 50)
    expect(sent).toEqual([moved, moved])
  })

  test('dragging a member with Alt moves it alone', () => {
    drag(PD, 50, 50, { altKey: true })
    expect(sent).toEqual([{ t: 'Move', doc: 'd1', tasks: { pd: [150, 150] }, loci: {} }])
  })

  test('a drag that is broken off puts boxes and dots back', () => {
    hand.down(event(TAB))
    hand.move(event(TAB, { clientX: 200 }))
    hand.cancel()
    expect([canvasState.scene.boxes.get('sum')!.x, canvasState.scene.dots.get('TAU')!.x, sent]).toEqual([400, 300, []])
  })

  test('Shift and a click on the tab turn all ON, and OFF where all are ON', () => {
    click(TAB, { shiftKey: true })
    desk.tree.documents.d1!.tasks!.sum!.state = 'ON'
    click(TAB, { shiftKey: true })
    expect(sent).toEqual([
      { t: 'TurnGroup', doc: 'd1', name: 'balance', is_on: true },
      { t: 'TurnGroup', doc: 'd1', name: 'balance', is_on: false },
    ])
  })

  test('Shift and a click on a member still toggle that one', () => {
    // table B.2
    click(PD, { shiftKey: true })
    expect(sent).toEqual([{ t: 'Toggle', doc: 'd1', task: 'pd' }])
  })

  test('a rectangle that touches one of its boxes selects all', () => {
    hand.down(event(GROUND, { clientX: 60, clientY: 60 }))
    hand.move(event(GROUND, { clientX: 130, clientY: 130 }))
    hand.up(event(GROUND, { clientX: 130, clientY: 130 }))
    expect([...canvas.picked]).toEqual(['sum', 'pd'])
  })
})

test('arrows move what belongs to a supermodule with it', () => {
  // R-C17, R-X11
  pick('pd', 'sum')
  nudge(5, 0)
  expect(sent).toEqual([
    { t: 'Move', doc: 'd1', tasks: { pd: [105, 100], sum: [405, 300] }, loci: { TAU: [305, 200] } },
  ])
})

describe('menus', () => {
  // R-C17
  test('of the tab offer to expand, to save and to turn it', () => {
    hand.context(event(TAB, { button: 2 }))
    expect(labels().slice(0, 5)).toEqual([
      'Switch ON',
      'Switch OFF',
      'Name and order…',
      'Expand into its parts',
      'Save the supermodule…',
    ])
    choose('Expand into its parts')
    hand.context(event(TAB, { button: 2 }))
    choose('Save the supermodule…')
    expect([sent, dialogs.current]).toEqual([
      [{ t: 'Ungroup', doc: 'd1', name: 'balance' }],
      { name: 'saveGroup', data: { group: 'balance' } },
    ])
  })

  test('of tasks offer to make one, unless they are one already', () => {
    pick('pd', 'sum', 'puma')
    hand.context(event(PD, { button: 2 }))
    const [makes] = [labels().includes('Make a supermodule…')]
    pick()
    hand.context(event(PD, { button: 2 }))
    expect([makes, labels().includes('Make a supermodule…'), labels().includes('Save balance…')]).toEqual([
      true,
      false,
      true,
    ])
  })

  test('of the canvas insert at the pointer', async () => {
    hand.context(event(GROUND, { button: 2, clientX: 203, clientY: 98 }))
    choose('Insert a supermodule…')
    expect(dialogs.current).toEqual({ name: 'insert', data: { x: '205', y: '100' } })
    expect(await insert('/lab/conf/x.conf', 205, 100)).toBe(true)
    expect(sent).toEqual([{ t: 'Insert', doc: 'd1', path: '/lab/conf/x.conf', x: 205, y: 100 }])
  })
})

test('without a pointer a supermodule is inserted in the middle of what is seen', () => {
  // R-C17
  openInsert()
  expect(dialogs.current.data).toEqual({ x: '450', y: '350' })
})

test('the name is asked beside the boxes, with one that is free', () => {
  // R-C17
  desk.tree.documents.d1!.groups!.super1 = { tasks: [] }
  askForName(['puma', 'pd'])
  expect(canvasState.opened).toEqual({ kind: 'group', at: { x: 100, y: 100 }, tasks: ['puma', 'pd'], name: 'super2' })
})

test('all that are selected are expanded', async () => {
  // R-C17
  pick('puma', 'pd', 'sum')
  await ungroup()
  expect(sent).toEqual([{ t: 'Ungroup', doc: 'd1', name: 'balance' }])
})
