// English: a recorded run that stands in a file and plays by itself; how it is made.
export const enPlayer = {
  'player.title': 'Run of {name}',
  'player.about': 'A recorded run. Nothing here reaches a robot or a network.',
  'player.onlyLooks': 'This file holds a recorded run: it can be looked at, and nothing in it can be changed.',
  'player.spoilt': 'This file cannot be played: {why}',
  'player.language': 'Language',
  'player.theme': 'Look',
  'share.share': 'Share…',
  'share.hint': 'Make one file of this recording that plays in any browser, without network and without Onika',
  'share.making': 'Making the file…',
  'share.made': '{file} is made ({size}). It plays in any browser.',
  'share.coarse': 'So that the file stays small, it shows an instant every {seconds} s.',
} as const
