// What the buttons mean on the canvas, row by row of table B.2.
import { beforeEach, describe, expect, test, vi } from 'vitest'
import type { AnyAct } from '../../src/api.gen'

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
const { PointerGestures } = await import('../../src/canvas/pointer')
const { KINDS } = await import('../../src/scene/scene.svelte')
const { canvasState } = await import('../../src/scene/canvasState.svelte')

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
const Q = new Thing({ locus: 'Q' })
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

beforeEach(() => {
  vi.stubGlobal('document', { elementFromPoint: () => null })
  const pins = [{ name: 'I', svar: 'Q', kind: 'INVAR' as const, y: 55 }]
  const task = (name: string) => ({
    name,
    module: name,
    library: 'g',
    order: 0,
    description: '',
    width: 136,
    height: 86,
    pins,
  })
  const tasks = Object.fromEntries(['pd', 'arm', 'jtraj'].map((name) => [name, task(name)]))
  desk.tree = fullTree({
    tasks,
    documents: {
      d1: {
        name: 'd',
        order: 1,
        tasks: { pd: { x: 100, y: 100 }, arm: { x: 400, y: 300 } },
        loci: { Q: { x: 300, y: 200 } },
      },
    },
  })
  canvas.doc = 'd1'
  canvas.libraryTask = ''
  canvas.pinned = []
  canvas.strip = 'tasks'
  dialogs.current = { name: '', data: {} }
  pick()
  canvasState.show('d1')
  Object.assign(canvasState.view, { left: 0, top: 0, seen: { x: 0, y: 0, scale: 1 }, size: { w: 900, h: 600 } })
  canvasState.scene.follow(desk.tree.documents.d1!, desk.tree.tasks, {
    kinds: new Set(KINDS),
    constants: true,
    opened: new Set(),
  })
  sent.length = 0
})

describe('the left button', () => {
  // R-G04
  test('on an icon selects it, and nothing else', () => {
    pick('arm')
    click(PD)
    expect([[...canvas.picked], sent]).toEqual([['pd'], []])
  })

  test('dragging an icon moves it, in one step', () => {
    // R-C10
    drag(PD, 62, 41)
    expect(sent).toEqual([{ t: 'Move', doc: 'd1', tasks: { pd: [160, 140] }, loci: {} }])
  })

  test('dragging one of several selected moves all', () => {
    pick('pd', 'arm')
    drag(PD, 50, 0)
    expect(sent).toMatchObject([{ tasks: { pd: [150, 100], arm: [450, 300] } }])
  })

  test('Alt lets it go exactly where it is dragged', () => {
    drag(PD, 62, 41, { altKey: true })
    expect(sent).toMatchObject([{ tasks: { pd: [162, 141] } }])
  })

  test('a drag that is broken off leaves everything where it was', () => {
    hand.down(event(PD))
    hand.move(event(PD, { clientX: 300 }))
    hand.cancel()
    expect([canvasState.scene.boxes.get('pd')!.x, sent]).toEqual([100, []])
  })

  test('on a locus pins its value, dragging moves it', () => {
    // R-C09
    click(Q)
    expect(canvas.pinned).toEqual(['Q'])
    hand.down(event(Q))
    hand.move(event(Q, { clientX: 333, clientY: 222 }))
    hand.up(event(Q, { clientX: 333, clientY: 222 }))
    expect(sent).toEqual([{ t: 'Move', doc: 'd1', tasks: {}, loci: { Q: [335, 220] } }])
  })

  test('a locus that is let go off the canvas goes back, and so does the paper; over the plots it is plotted', () => {
    // R-C09, R-C14
    const plots = new Thing({ drop: 'plots' })
    for (const [under, plotted] of [
      [null, []],
      [plots, ['Q']],
    ] as const) {
      canvas.plots = []
      vi.stubGlobal('document', { elementFromPoint: () => under })
      hand.down(event(Q))
      hand.move(event(Q, { clientX: 200, clientY: 200 }))
      canvasState.view.pan(-40, -30) // an edge has drawn it along meanwhile
      hand.move(event(Q, { clientX: 700, clientY: 640 }))
      hand.up(event(Q, { clientX: 700, clientY: 640 }))
      expect([sent, canvas.plots, canvasState.view.seen]).toEqual([[], plotted, { x: 0, y: 0, scale: 1 }])
      expect(canvasState.scene.dots.get('Q')).toMatchObject({ x: 300, y: 200 })
    }
  })

  test('on empty canvas deselects; dragged it picks what it touches', () => {
    click(PD)
    click(GROUND)
    expect(canvas.picked.size).toBe(0)
    drag(GROUND, 400, 400)
    expect([...canvas.picked]).toEqual(['pd', 'arm'])
    expect(canvasState.marquee).toBeUndefined()
  })

  test('with Shift on an icon switches it, on a locus hides its lines', () => {
    // R-C11
    click(PD, { shiftKey: true })
    click(Q, { shiftKey: true })
    expect(sent).toEqual([
      { t: 'Toggle', doc: 'd1', task: 'pd' },
      { t: 'Show', doc: 'd1', svars: ['Q'], is_shown: false },
    ])
  })

  test('with Ctrl selects one more, or one less', () => {
    click(PD, { ctrlKey: true })
    click(new Thing({ task: 'arm' }), { ctrlKey: true })
    click(PD, { ctrlKey: true })
    expect([...canvas.picked]).toEqual(['arm'])
  })
})

describe('the middle button', () => {
  // R-G04
  test.each([
    [{}, { name: 'sheet', data: { task: 'pd' } }],
    [{ shiftKey: true }, { name: 'source', data: { task: 'pd', kind: 'code' } }],
    [{ ctrlKey: true }, { name: 'source', data: { task: 'pd', kind: 'rmod' } }],
  ])('on an icon, with %o, opens what belongs to it', (keys, dialog) => {
    click(PD, { button: 1, ...keys })
    expect(dialogs.current).toEqual(dialog)
  })

  test('on a locus tells what is known of it', () => {
    click(Q, { button: 1 })
    expect(canvasState.opened).toMatchObject({ kind: 'locus', svar: 'Q' })
  })

  test('with Shift elsewhere checks the configuration', () => {
    // R-C26
    click(GROUND, { button: 1, shiftKey: true })
    expect(sent).toEqual([{ t: 'Check', doc: 'd1' }])
  })

  test('dragging empty canvas moves the paper', () => {
    drag(GROUND, 30, 20, { button: 1 })
    expect(canvasState.view.seen).toEqual({ x: 30, y: 20, scale: 1 })
  })
})

describe('the right button', () => {
  // R-G04
  test('places what is selected in the library, with its corner there', () => {
    canvas.libraryTask = 'jtraj'
    hand.context(event(PD, { button: 2 }))
    expect(sent).toEqual([{ t: 'Place', doc: 'd1', task: 'jtraj', x: 120, y: 120, rtpu: '' }])
  })

  test('asks for the processing unit where several live', () => {
    // R-C11
    canvas.libraryTask = 'jtraj'
    desk.tree.documents.d1!.connection = 'live'
    desk.tree.runtime = { units: { rt0: {}, rt1: {}, rt2: { is_lost: true } } }
    hand.context(event(GROUND, { button: 2 }))
    expect([canvasState.opened, sent]).toEqual([
      { kind: 'units', at: { x: 120, y: 120 }, task: 'jtraj', corner: [120, 120] },
      [],
    ])
  })

  test('opens a menu where nothing is selected there, of what lies under it', () => {
    hand.context(event(PD, { button: 2 }))
    expect(canvasState.opened).toMatchObject({ kind: 'menu', over: { kind: 'task', name: 'pd' } })
    expect([...canvas.picked]).toEqual(['pd'])
  })

  test('the key for menus, or a long touch, opens it all the same', () => {
    canvas.libraryTask = 'jtraj'
    hand.context(event(GROUND, { button: 0 }))
    expect([canvasState.opened.kind, sent]).toEqual(['menu', []])
  })
})

describe('fingers', () => {
  // R-G04
  const touch = (id: number, x: number): PointerEvent =>
    event(GROUND, { pointerId: id, pointerType: 'touch', clientX: x })

  test('one moves the paper', () => {
    drag(GROUND, 40, 0, { pointerType: 'touch' })
    expect(canvasState.view.seen.x).toBe(40)
  })

  test('two scale it, and what is between them stays between them', () => {
    hand.down(touch(1, 100))
    hand.down(touch(2, 200))
    hand.move(touch(2, 300))
    hand.up(touch(1, 100))
    hand.up(touch(2, 300))
    expect(canvasState.view.scale).toBe(2)
    expect(canvasState.view.toScene(200, 0)[0]).toBe(150)
  })
})

test('a double click looks for a task to place, or opens what it is on', () => {
  hand.double(event(GROUND))
  expect(canvasState.opened).toEqual({ kind: 'quick', at: { x: 120, y: 120 } })
  hand.double(event(Q))
  expect(canvasState.opened.kind).toBe('locus')
  hand.double(event(PD))
  expect(dialogs.current.name).toBe('sheet')
})
