// A card lies beside its box where it hides least.
import { describe, expect, test } from 'vitest'
import { placeCard, corner } from '../../src/canvas/cardPlacement'

const box = { x: 300, y: 300, w: 136, h: 100 }
const card = { w: 210, h: 90 }

describe('a card', () => {
  test('lies below its box', () => {
    expect(placeCard(box, card, [])).toBe('below')
    expect(corner('below', box, card)).toEqual({ x: -16, y: 108 })
    expect(corner('below', box, { w: 136, h: 60 })).toEqual({ x: 0, y: 108 })
  })

  test('goes to another side rather than hide a box', () => {
    const below = { x: 300, y: 430, w: 136, h: 100 }
    const above = { x: 300, y: 180, w: 136, h: 100 }
    expect(placeCard(box, card, [below])).toBe('above')
    expect(placeCard(box, card, [below, above])).toBe('right')
    expect(placeCard(box, card, [below, above, { x: 500, y: 300, w: 136, h: 100 }])).toBe('left')
  })

  test('beside a tall box lies at its foot where its head has company', () => {
    const tall = { ...box, h: 400 }
    const all = [
      { x: 300, y: 720, w: 136, h: 100 },
      { x: 300, y: 180, w: 136, h: 100 },
      { x: 460, y: 300, w: 136, h: 100 },
      { x: 100, y: 300, w: 136, h: 100 },
    ]
    expect(placeCard(tall, card, all)).toBe('low right')
    expect(corner('low right', tall, card)).toEqual({ x: 158, y: 310 })
  })

  test('stays where it can be seen', () => {
    expect(placeCard(box, card, [], { x0: 0, y0: 0, x1: 900, y1: 410 })).toBe('above')
  })

  test('hides least where it must hide something', () => {
    const all = [
      { x: 200, y: 430, w: 400, h: 100 },
      { x: 200, y: 100, w: 400, h: 100 },
      { x: 460, y: 280, w: 136, h: 200 },
      { x: 40, y: 280, w: 200, h: 200 },
    ]
    expect(placeCard(box, card, all)).toBe('above')
  })
})
