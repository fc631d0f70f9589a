// What is said to beginners among words alone, where it would speak of pictures, edges and colours that nobody sees (H04).
import { isWordsOnly } from './presentation'
import type { TextKey } from '../texts/index.svelte'

const AMONG_WORDS: Partial<Record<TextKey, TextKey>> = {
  'help.pictures': 'help.words',
  'guide.lead': 'guideWords.lead',
  'guide.choose': 'guideWords.choose',
  'guide.putSay': 'guideWords.putSay',
  'guide.fit': 'guideWords.fit',
  'guide.fitSay': 'guideWords.fitSay',
  'guide.holeSay': 'guideWords.holeSay',
  'guide.changeSay': 'guideWords.changeSay',
  'guide.inside': 'guideWords.inside',
  'upper.empty.title': 'upper.emptyWords.title',
  'upper.empty.say': 'upper.emptyWords.say',
  'upper.first.title1': 'upper.firstWords.title1',
  'upper.first.joinSay': 'upper.firstWords.joinSay',
  'upper.first.fitSay': 'upper.firstWords.fitSay',
  'upper.first.runSay': 'upper.firstWords.runSay',
  'tutorial.completeHow': 'tutorialWords.completeHow',
  'tutorial.jobHow': 'tutorialWords.jobHow',
  'tutorial.fill': 'tutorialWords.fill',
  'tutorial.saveHow': 'tutorialWords.saveHow',
}

/** The sentence that is true of what is shown. */
export const worded = (key: TextKey): TextKey => (isWordsOnly() ? (AMONG_WORDS[key] ?? key) : key)
