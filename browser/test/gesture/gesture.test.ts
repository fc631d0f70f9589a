// A press becomes a click or another gesture; a task is carried only once the pointer has moved.
import { beforeEach, describe, expect, test, vi } from 'vitest'
import type { Gesture } from '../../src/gesture/gesture'
import { Press } from '../../src/gesture/press'

const at = (clientX: number, clientY: number, more: Partial<PointerEvent> = {}): PointerEvent =>
  ({ clientX, clientY, button: 0, isPrimary: true, pointerId: 1, ...more }) as PointerEvent

describe('a press', () => {
  const drag: Gesture = { move: vi.fn(), up: vi.fn(), cancel: vi.fn() }
  const click = vi.fn()
  beforeEach(() => vi.clearAllMocks())

  test('that trembles is a click', () => {
    const press = new Press(at(10, 10), click, () => drag)
    press.move(at(12, 11))
    press.up(at(12, 11))
    expect(click).toHaveBeenCalledOnce()
    expect(drag.move).not.toHaveBeenCalled()
  })

  test('that moves is a drag from where it began, and no click', () => {
    const begun = vi.fn(() => drag)
    const first = at(10, 10)
    const press = new Press(first, click, begun)
    press.move(at(20, 10))
    press.move(at(30, 10))
    press.up(at(30, 10))
    expect(begun.mock.calls).toEqual([[first]])
    expect(drag.move).toHaveBeenCalledTimes(2)
    expect(drag.up).toHaveBeenCalledOnce()
    expect(click).not.toHaveBeenCalled()
  })

  test('that moves where nothing can be dragged means nothing', () => {
    const press = new Press(at(0, 0), click)
    press.move(at(50, 0))
    press.up(at(50, 0))
    expect(click).not.toHaveBeenCalled()
  })

  test('is taken back with what it became', () => {
    const press = new Press(at(0, 0), click, () => drag)
    press.move(at(50, 0))
    press.cancel()
    expect(drag.cancel).toHaveBeenCalledOnce()
  })
})
