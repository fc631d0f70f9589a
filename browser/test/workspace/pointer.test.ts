// What buttons mean in the workspace, row by row of table B.4.
import { beforeEach, describe, expect, test, vi } from 'vitest'
import type { AnyAct } from '../../src/api.gen'

const { sent, answers } = vi.hoisted(() => {
  vi.stubGlobal('navigator', { language: 'en' })
  vi.stubGlobal('Element', class {})
  vi.stubGlobal('HTMLElement', class {})
  return { sent: [] as AnyAct[], answers: new Map<string, unknown>() }
})
vi.mock('../../src/link/link', () => ({
  send: (act: AnyAct) => (act.t === 'Note' || sent.push(act), Promise.resolve(answers.get(act.t) ?? null)),
  hear: () => () => undefined,
}))

const { Refusal } = await import('../../src/link/refusal')
const { plain } = await import('../../src/texts/say')
const { desk } = await import('../../src/link/desk.svelte')
const { dialogs } = await import('../../src/state/dialogs.svelte')
const { pickSteps, workspace } = await import('../../src/state/workspace.svelte')
const { workspaceState } = await import('../../src/workspace/workspaceState.svelte')
const { PointerGestures } = await import('../../src/workspace/pointer')
const { askForOther, exchange, paste, replaceable } = await import('../../src/workspace/acts')
const { slotAt } = await import('../../src/workspace/slot')
const { openProgram } = await import('./openProgram')

/** Something in the workspace that a pointer may be over. */
class Thing extends (Element as unknown as new () => object) {
  constructor(readonly dataset: Record<string, string>) {
    super()
  }

  closest(): Thing | null {
    return Object.keys(this.dataset).length ? this : null
  }
}
const GROUND = new Thing({})
const hand = new PointerGestures()

/** The middle of a step, as the pointer finds it. */
function at(step: number): { clientX: number; clientY: number } {
  const cell = workspaceState.cells.get(step)
  return cell ? { clientX: cell.x + cell.w / 2, clientY: cell.y + 32 } : { clientX: 5, clientY: 500 }
}
const over = (step: number): Thing => new Thing({ step: String(step), flow: '0' })
const event = (target: Thing, more: Partial<PointerEvent> = {}): PointerEvent =>
  ({
    target,
    button: 0,
    pointerId: 1,
    pointerType: 'mouse',
    preventDefault: () => undefined,
    ...more,
  }) as unknown as PointerEvent

function click(step: number, more: Partial<PointerEvent> = {}): void {
  const one = event(step ? over(step) : GROUND, { ...at(step), ...more })
  hand.down(one)
  hand.up(one)
}
function drag(step: number, to: number, more: Partial<PointerEvent> = {}): void {
  hand.down(event(over(step), { ...at(step), ...more }))
  const there = {
    clientX: (workspaceState.base.gaps.find((gap) => gap.after === to)?.x ?? 0) + 1,
    clientY: at(step).clientY,
  }
  hand.move(event(over(step), { ...there, ...more }))
  hand.up(event(over(step), { ...there, ...more }))
}
const settled = (): Promise<void> => new Promise((done) => setTimeout(done))

beforeEach(() => {
  openProgram()
  sent.length = 0
  answers.clear()
})

describe('the left button', () => {
  test('selects the icon, and the next one goes behind it', () => {
    // R-G04
    click(2)
    expect([...workspace.steps]).toEqual([2])
    expect(workspace.place).toEqual({ flow: '0', after: 2 })
  })

  test('over empty space selects nothing', () => {
    // R-G04
    click(2)
    click(0)
    expect(workspace.steps.size).toBe(0)
  })

  test('with Ctrl selects several', () => {
    click(2)
    click(4, { ctrlKey: true })
    expect([...workspace.steps]).toEqual([2, 4])
  })

  test('with Shift over a job opens its configuration', () => {
    // R-D12 R-G04
    click(1, { shiftKey: true })
    expect(sent).toEqual([{ t: 'Open', path: '/b/conf/open.conf' }])
  })

  test('drags an action with its target elsewhere', () => {
    // R-D05
    drag(2, 0)
    expect(sent).toEqual([{ t: 'MoveIcons', doc: 'a1', steps: [2, 3], flow: '0', after: 0 }])
  })

  test('drags a target alone', () => {
    drag(3, 1)
    expect(sent[0]).toMatchObject({ t: 'MoveIcons', steps: [3], after: 1 })
  })

  test('with Ctrl drags copies', async () => {
    drag(4, 0, { ctrlKey: true })
    await settled()
    expect(sent.map((act) => act.t)).toEqual(['CopyIcons', 'PasteIcons'])
  })

  test('drags nothing where it is let go where it was', () => {
    drag(2, 1)
    drag(2, 3)
    expect(sent).toEqual([])
  })

  test('drags nothing while the application runs', () => {
    // R-D18
    desk.tree.applications.a1!.is_running = true
    drag(2, 0)
    expect(sent).toEqual([])
  })
})

/** Drag a step by the mouse to a place of the window, and let it go there. */
function dropAt(step: number, clientX: number, clientY: number): void {
  const there = { clientX, clientY }
  hand.down(event(over(step), at(step)))
  hand.move(event(over(step), there))
  hand.up(event(over(step), there))
}

describe('an icon that is dropped', () => {
  const bounds = { left: 0, top: 0, right: 1000, bottom: 600 }
  const ground = { getBoundingClientRect: () => bounds, contains: () => false }
  beforeEach(() => {
    vi.stubGlobal('window', { innerWidth: 1200, innerHeight: 700 })
    Object.assign(workspaceState, { ground })
    return () => Object.assign(workspaceState, { ground: undefined })
  })

  test('on the picture of another one replaces it, with its targets', () => {
    // R-D05
    const { clientX, clientY } = at(4)
    dropAt(2, clientX, clientY)
    expect(sent).toEqual([{ t: 'MoveIcons', doc: 'a1', steps: [2, 3], flow: '0', after: 3, replaces: 4 }])
  })

  test('on itself stays', () => {
    const { clientX, clientY } = at(2)
    dropAt(2, clientX + 6, clientY)
    expect(sent).toEqual([])
  })

  test('outside of the workspace is deleted with its targets', () => {
    // R-D05
    dropAt(2, 1100, 300)
    expect(sent).toEqual([{ t: 'RemoveIcons', doc: 'a1', steps: [2, 3] }])
  })

  test('outside as a copy, beyond the window, or while it runs, is not', () => {
    // R-D18
    hand.down(event(over(2), { ...at(2), ctrlKey: true }))
    hand.move(event(over(2), { clientX: 1100, clientY: 300, ctrlKey: true }))
    hand.up(event(over(2), { clientX: 1100, clientY: 300, ctrlKey: true }))
    dropAt(2, 1300, 300)
    dropAt(2, 500, 590)
    desk.tree.applications.a1!.is_running = true
    dropAt(2, 1100, 300)
    expect(sent).toEqual([])
  })

  test('tells before it is let go what becomes of it', () => {
    hand.down(event(over(2), at(2)))
    const { clientX, clientY } = at(4)
    hand.move(event(over(2), { clientX, clientY }))
    expect(workspaceState.slot).toMatchObject({ replaces: 4, why: '' })
    hand.move(event(over(2), { clientX: 1100, clientY: 300 }))
    expect(workspaceState.lifted?.isOutside).toBe(true)
    hand.cancel()
    expect(sent).toEqual([])
  })

  test('from a dictionary on a picture comes in its place, and is told where it fits not', () => {
    const { clientX, clientY } = at(4)
    expect(slotAt({ x: clientX, y: clientY }, '0', '0')).toMatchObject({ replaces: 4, after: 3, why: '' })
    expect(slotAt({ x: clientX, y: clientY }, '1', '0')?.why).not.toBe('')
    expect(slotAt({ x: clientX - 44, y: clientY }, '0', '0')).toMatchObject({ replaces: 0, after: 3 })
  })
})

describe('what comes in the place of an icon', () => {
  test('is looked for by a key, and stands there when it is chosen', async () => {
    // R-D05 R-X11
    click(4)
    expect(replaceable()).toBe(4)
    askForOther()
    expect(workspaceState.opened).toEqual({ kind: 'quick', words: '', replaces: 4 })
    expect(await exchange(4, 'open')).toBe(true)
    expect(sent).toEqual([{ t: 'ExchangeIcon', doc: 'a1', step: 4, onikon: 'open' }])
    expect([...workspace.steps]).toEqual([4])
  })

  test('is of one icon only', () => {
    click(2)
    click(4, { ctrlKey: true })
    expect(replaceable()).toBe(0)
  })
})

test('what is pasted goes behind the selection, else to the cursor', async () => {
  // R-D05
  pickSteps(2, 3)
  workspace.place = { flow: '0', after: 0 }
  await paste()
  pickSteps()
  workspace.place = { flow: '0', after: 1 }
  await paste()
  expect(sent).toMatchObject([
    { t: 'PasteIcons', after: 3 },
    { t: 'PasteIcons', after: 1 },
  ])
})

describe('the middle button', () => {
  test('shows name and types of an action', () => {
    // R-G04
    click(1, { button: 1 })
    expect(workspaceState.opened).toEqual({ kind: 'facts', step: 1 })
  })

  test('shows the values of an object, which can be edited', () => {
    // R-G04 R-D08
    click(3, { button: 1 })
    expect(dialogs.current).toEqual({ name: 'icon', data: { step: '3' } })
  })

  test('with Shift opens the picture editor', () => {
    // R-G04
    click(1, { button: 1, shiftKey: true })
    expect(dialogs.current).toEqual({ name: 'icon', data: { step: '1', tab: 'picture' } })
  })
})

describe('the right button', () => {
  test('inserts what is selected in the dictionary behind the icon', async () => {
    // R-G04 R-D03
    workspace.onikon = 'open'
    answers.set('InsertIcon', 9)
    hand.context(event(over(3), { ...at(3), button: 2 }))
    await settled()
    expect(sent).toEqual([{ t: 'InsertIcon', doc: 'a1', onikon: 'open', flow: '0', after: 3 }])
    expect(workspace.onikon).toBe('')
  })

  test('leaves selected what is selected next, before the answer is there', async () => {
    // R-D03
    workspace.onikon = 'open'
    hand.context(event(over(3), { ...at(3), button: 2 }))
    workspace.onikon = 'turn'
    await settled()
    expect(workspace.onikon).toBe('turn')
  })

  test('leaves selected what is refused', async () => {
    // R-D03
    workspace.onikon = 'open'
    answers.set('InsertIcon', Promise.reject(new Refusal(plain('no'))))
    hand.context(event(over(3), { ...at(3), button: 2 }))
    await settled()
    expect(workspace.onikon).toBe('open')
  })

  test('shows nothing of the press where the answer comes soon', async () => {
    // R-G07
    workspace.onikon = 'open'
    answers.set('InsertIcon', 9)
    const place = workspace.place
    hand.down(event(over(3), { ...at(3), button: 2 }))
    expect([workspace.onikon, workspace.place, [...workspace.steps]]).toEqual(['open', place, []])
    await settled()
    expect([workspace.onikon, workspace.place]).toEqual(['', { flow: '0', after: 9 }])
  })

  test('shows the press where the answer comes late', async () => {
    // R-G07
    vi.useFakeTimers()
    workspace.onikon = 'open'
    answers.set('InsertIcon', new Promise(() => undefined))
    hand.down(event(over(3), { ...at(3), button: 2 }))
    vi.advanceTimersByTime(60)
    vi.useRealTimers()
    expect([workspace.onikon, workspace.place, [...workspace.steps]]).toEqual(['', { flow: '0', after: 3 }, [3]])
  })

  test('inserts once where it is pressed again before the answer', async () => {
    // R-D03
    workspace.onikon = 'open'
    answers.set('InsertIcon', 9)
    for (const step of [3, 1]) hand.down(event(over(step), { ...at(step), button: 2 }))
    await settled()
    expect(sent).toHaveLength(1)
  })

  test('opens a menu where nothing is selected there', () => {
    hand.context(event(over(3), { ...at(3), button: 2 }))
    expect(workspaceState.opened).toMatchObject({ kind: 'menu', over: { kind: 'step', step: 3 } })
    expect([...workspace.steps]).toEqual([3])
  })
})

test('a double click edits', () => {
  hand.double(event(over(3), at(3)) as unknown as MouseEvent)
  expect(dialogs.current).toEqual({ name: 'icon', data: { step: '3' } })
})
