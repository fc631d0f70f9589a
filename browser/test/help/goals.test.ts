import { describe, expect, it } from 'vitest'
import { goalsOf, resultsOf } from '../../src/help/goals'

const puzzle = {
  goals: ['GRIP_MEZ[0] > 0.07', 'GRIP_MEZ[0] < 0.08', 'LAMP == 1'],
  goal_words: [{ conditions: 2, words: { en: 'the hand holds a box', es: 'la mano tiene una caja' } }],
}

describe('the goals of a puzzle', () => {
  it('are said in the language of the page, and what has no words is shown as it is', () => {
    expect(goalsOf(puzzle, 'es')).toEqual([
      { words: 'la mano tiene una caja', conditions: ['GRIP_MEZ[0] > 0.07', 'GRIP_MEZ[0] < 0.08'] },
      { words: '', conditions: ['LAMP == 1'] },
    ])
  })

  it('are said in English where there are no other words', () => {
    expect(goalsOf({ ...puzzle, goal_words: [{ conditions: 1, words: { en: 'open' } }] }, 'es')[0]!.words).toBe('open')
  })

  it('have what came of each of their conditions', () => {
    const came = puzzle.goals.map((text, k) => ({ text, is_met: k > 0, found: '' }))
    const results = resultsOf(goalsOf(puzzle, 'en'), came)
    expect(results.map(({ came }) => came.map(({ is_met }) => is_met))).toEqual([[false, true], [true]])
  })
})
