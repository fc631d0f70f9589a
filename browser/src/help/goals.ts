// What a puzzle wants, in words for who learns; each stands for one condition, or for several.
import type { GoalView, GoalWordsView } from '../api.gen'

export interface Goal {
  /** Empty: nobody has said it in words. */
  words: string
  conditions: readonly string[]
}

/** Its goals in a language, else in English; conditions that are left over each stand for themselves. */
export function goalsOf(
  puzzle: { goals?: readonly string[]; goal_words?: readonly GoalWordsView[] },
  language: string,
): Goal[] {
  const left = [...(puzzle.goals ?? [])]
  const said = (puzzle.goal_words ?? []).map(({ conditions, words = {} }) => ({
    words: words[language] ?? words['en'] ?? '',
    conditions: left.splice(0, conditions),
  }))
  return [...said, ...left.map((condition) => ({ words: '', conditions: [condition] }))]
}

/** What came of each: the conditions of a run stand in the order of those of the puzzle. */
export const resultsOf = (goals: readonly Goal[], results: readonly GoalView[]): { goal: Goal; came: GoalView[] }[] => {
  const left = [...results]
  return goals.map((goal) => ({ goal, came: left.splice(0, goal.conditions.length) }))
}
