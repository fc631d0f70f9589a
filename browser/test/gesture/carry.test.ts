// Something on its way from a library to where it is used.
import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest'
import { Carry, type Ground } from '../../src/gesture/carry.svelte'

const heard = new EventTarget()
const event = (name: string, more: object): Event => Object.assign(new Event(name, { cancelable: true }), more)
const say = (name: string, more: object): void => void heard.dispatchEvent(event(name, more))
const down = (x: number, y: number): PointerEvent =>
  event('pointerdown', { clientX: x, clientY: y, button: 0, isPrimary: true, pointerId: 1 }) as PointerEvent
const move = (x: number, y: number): void => say('pointermove', { clientX: x, clientY: y, pointerId: 1 })
const up = (): void => say('pointerup', { pointerId: 1 })

describe('carrying', () => {
  // R-G04
  const carry = new Carry('lexi')
  const ground = { holds: (x: number) => x > 100, drop: vi.fn() } satisfies Ground
  beforeEach(() => {
    vi.stubGlobal('window', heard)
    carry.ground = ground
    ground.drop.mockClear()
  })
  afterEach(() => {
    carry.stop()
    vi.unstubAllGlobals()
  })

  test('a click carries nothing', () => {
    carry.begin('pd', down(10, 10))
    move(12, 10)
    expect(carry.isUnderWay).toBe(false)
    up()
    expect(ground.drop).not.toHaveBeenCalled()
  })

  test('over the canvas it is dropped where the pointer is', () => {
    carry.begin('pd', down(10, 10))
    move(200, 50)
    expect([carry.name, carry.isOverGround]).toEqual(['pd', true])
    up()
    expect(ground.drop).toHaveBeenCalledWith('pd', 200, 50)
    expect(carry.isUnderWay).toBe(false)
  })

  test('elsewhere it goes back', () => {
    carry.begin('pd', down(10, 10))
    move(90, 50)
    up()
    expect(ground.drop).not.toHaveBeenCalled()
  })

  test('Esc puts it back, and nothing is heard afterwards', () => {
    carry.begin('pd', down(10, 10))
    move(200, 50)
    say('keydown', { key: 'Escape' })
    expect(carry.isUnderWay).toBe(false)
    move(220, 50)
    up()
    expect([carry.isUnderWay, ground.drop.mock.calls.length]).toEqual([false, 0])
  })

  test('only the main button carries', () => {
    carry.begin('pd', Object.assign(down(10, 10), { button: 1 }) as PointerEvent)
    move(200, 50)
    expect(carry.isUnderWay).toBe(false)
  })
  test('where the ground wants to know, it is told of every move, and once of the end', () => {
    const told: string[] = []
    carry.ground = {
      ...ground,
      hover: (name, x) => void told.push(`${name} at ${x}`),
      leave: () => void told.push('left'),
    }
    carry.begin('home', down(10, 10))
    move(200, 50)
    move(210, 50)
    move(50, 50)
    move(120, 50)
    say('keydown', { key: 'Escape' })
    expect(told).toEqual(['home at 200', 'home at 210', 'left', 'home at 120', 'left'])
  })
})
