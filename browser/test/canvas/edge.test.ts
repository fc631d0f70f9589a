// What is dragged to the edge draws the paper along.
import { expect, test, vi } from 'vitest'

const frames = vi.hoisted(() => {
  const asked: (() => void)[] = []
  vi.stubGlobal('navigator', { language: 'en' })
  vi.stubGlobal('requestAnimationFrame', (then: () => void) => asked.push(then))
  vi.stubGlobal('cancelAnimationFrame', () => undefined)
  return asked
})
vi.mock('../../src/link/link', () => ({ send: () => Promise.resolve(null) }))

const { Edge, pull } = await import('../../src/canvas/edge')
const { canvasState } = await import('../../src/scene/canvasState.svelte')

test('in the middle nothing moves', () => {
  expect(pull(300, 0, 600)).toBe(0)
  expect(pull(28, 0, 600)).toBe(0)
})

test('at an edge the paper comes from beyond it, faster the nearer', () => {
  expect(pull(4, 0, 600)).toBeGreaterThan(pull(20, 0, 600))
  expect(pull(596, 0, 600)).toBe(-pull(4, 0, 600))
})

test('a little beyond the edge it is never faster than at it, and farther out it stops', () => {
  expect(pull(-20, 0, 600)).toBe(pull(0, 0, 600))
  expect(pull(-60, 0, 600)).toBe(0)
})

test('on its way to what lies beneath the canvas a locus draws nothing along; at the other edges it does', () => {
  Object.assign(canvasState.view, { left: 0, top: 0, size: { w: 800, h: 600 } })
  const asks = (x: number, y: number, isForBelow: boolean): boolean => {
    frames.length = 0
    Object.assign(canvasState, { isHolding: true, isForBelow })
    new Edge().follow({ clientX: x, clientY: y } as PointerEvent, () => undefined)
    return frames.length > 0
  }
  expect([asks(400, 590, false), asks(400, 4, false)]).toEqual([true, true])
  expect([asks(400, 590, true), asks(795, 610, true)]).toEqual([false, false])
  expect([asks(400, 4, true), asks(795, 300, true)]).toEqual([true, true])
})
