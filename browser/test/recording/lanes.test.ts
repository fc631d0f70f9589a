import { describe, expect, it } from 'vitest'
import type { RecordingView } from '../../src/api.gen'
import { beginnings, blocksUntil, lanesOf, nextTo, passageAt, ticksOf } from '../../src/recording/lanes'
import { plain } from '../../src/texts/say'

const recording: RecordingView = {
  path: '/r.mcap',
  name: 'assemble',
  begin_s: 0,
  end_s: 10,
  flows: {
    b: { order: 1, passages: [{ action: 0, name: 'wait', begin_s: 1, end_s: 4, step: 7 }] },
    a: {
      order: 0,
      passages: [
        { action: 0, name: 'open', begin_s: 1, end_s: 3, step: 2 },
        { action: 1, name: 'move', begin_s: 3, end_s: null, step: 3 },
      ],
    },
  },
  marks: [{ at_s: 8, kind: 'stop', text: plain('the box is gone') }],
}

describe('A recorded run as lanes', () => {
  it('has the flows in their order', () => {
    expect(lanesOf(recording).map((lane) => lane.subsystem)).toEqual(['a', 'b'])
  })

  it('tells what a flow carried out at an instant, and nothing between its actions', () => {
    const [a, b] = lanesOf(recording) as [ReturnType<typeof lanesOf>[0], ReturnType<typeof lanesOf>[0]]
    expect(passageAt(a, 2)?.name).toBe('open')
    expect(passageAt(a, 3)?.name).toBe('move')
    expect(passageAt(a, 9)?.name).toBe('move')
    expect(passageAt(b, 5)).toBeUndefined()
    expect(passageAt(b, 0.5)).toBeUndefined()
  })

  it('steps from one beginning to the next and back, also from between them', () => {
    const moments = beginnings(recording)
    expect(moments).toEqual([0, 1, 3])
    expect(nextTo(moments, 1, 1)).toBe(3)
    expect(nextTo(moments, 2.5, -1)).toBe(1)
    expect(nextTo(moments, 1, -1)).toBe(0)
    expect(nextTo(moments, 3, 1)).toBeUndefined()
  })

  it('shows at an instant only what had begun, and as still going what had not ended', () => {
    const blocks = blocksUntil(recording, 2)
    expect(blocks.map((block) => [block.flow, block.step, block.to_s])).toEqual([
      [0, 2, NaN],
      [1, 7, NaN],
    ])
    expect(blocksUntil(recording, 5).map((block) => block.to_s)).toEqual([3, 4, NaN])
  })

  it('draws what is carried out as a fault where its flow stands still, and nothing else', () => {
    expect(blocksUntil(recording, 2).some((block) => block.isFault)).toBe(false)
    expect(
      blocksUntil(recording, 9, new Set([0]))
        .filter((block) => block.isFault)
        .map((block) => block.step),
    ).toEqual([3])
    expect(blocksUntil(recording, 9, new Set([1])).some((block) => block.isFault)).toBe(false)
  })

  it('gathers marks that would lie upon each other, and shows the gravest', () => {
    const marks = [
      { at_s: 1, kind: 'command', text: plain('pause') },
      { at_s: 1.01, kind: 'error', text: plain('late') },
      { at_s: 5, kind: 'meet', text: plain('at m') },
    ] as const
    const ticks = ticksOf(marks, (at_s) => at_s * 100)
    expect(ticks.map((tick) => [tick.kind, tick.marks.length])).toEqual([
      ['error', 2],
      ['meet', 1],
    ])
  })
})
