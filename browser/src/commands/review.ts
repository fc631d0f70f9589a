// Commands of recordings: open one, scrub it, lay another beside it, go on from it.
import { command } from '../state/commands'
import { openDialog } from '../state/dialogs.svelte'
import { isPages } from '../state/keyboard'
import { look } from '../state/look.svelte'
import { closeRecording, compareWith, continueHere, share, toMark } from '../recording/acts'
import { PACES, review } from '../recording/review.svelte'
import { t } from '../texts/index.svelte'

const isOpen = (): boolean => review.isOpen
function faster(by: 1 | -1): void {
  review.setPace(PACES[Math.min(PACES.length - 1, Math.max(0, PACES.findIndex((pace) => pace === review.pace) + by))]!)
}

command({
  id: 'review.open',
  group: 'file',
  title: () => t('recordings.file'),
  keys: ['Alt+O'],
  when: () => !look.isFixed,
  run: () => openDialog('recordings'),
})
command({
  id: 'review.play',
  group: 'review',
  title: () => t(review.isPlaying ? 'review.pause' : 'review.play'),
  keys: ['Alt+P', 'Space'],
  when: isOpen,
  run: () => review.play(),
})
command({
  id: 'review.previous',
  group: 'review',
  title: () => t('review.previous'),
  keys: [','],
  when: isOpen,
  run: () => review.step(-1),
})
command({
  id: 'review.next',
  group: 'review',
  title: () => t('review.next'),
  keys: ['.'],
  when: isOpen,
  run: () => review.step(1),
})
command({
  id: 'review.back',
  group: 'review',
  title: () => t('review.back'),
  keys: ['←'],
  when: isOpen,
  run: () => review.go(review.at_s - 1),
})
command({
  id: 'review.forth',
  group: 'review',
  title: () => t('review.forth'),
  keys: ['→'],
  when: isOpen,
  run: () => review.go(review.at_s + 1),
})
command({
  id: 'review.begin',
  group: 'review',
  title: () => t('review.toBegin'),
  keys: ['Home'],
  when: isOpen,
  run: () => review.go(review.begin_s),
})
command({
  id: 'review.end',
  group: 'review',
  title: () => t('review.toEnd'),
  keys: ['End'],
  when: isOpen,
  run: () => review.go(review.end_s),
})
command({
  id: 'review.previousMark',
  group: 'review',
  title: () => t('review.previousMark'),
  keys: ['PageUp'],
  when: () => review.isOpen && isPages(),
  run: () => toMark(-1),
})
command({
  id: 'review.nextMark',
  group: 'review',
  title: () => t('review.nextMark'),
  keys: ['PageDown'],
  when: () => review.isOpen && isPages(),
  run: () => toMark(1),
})
command({
  id: 'review.slower',
  group: 'review',
  title: () => t('review.slower'),
  keys: ['Alt+,'],
  when: isOpen,
  run: () => faster(-1),
})
command({
  id: 'review.faster',
  group: 'review',
  title: () => t('review.faster'),
  keys: ['Alt+.'],
  when: isOpen,
  run: () => faster(1),
})
command({
  id: 'review.compare',
  group: 'review',
  title: () => t('review.compare'),
  when: () => review.isOpen && !look.isFixed,
  run: () => openDialog('recordings', { what: 'compare' }),
})
command({
  id: 'review.one',
  group: 'review',
  title: () => t('review.noMore'),
  when: () => review.other !== undefined,
  run: () => compareWith(''),
})
command({
  id: 'review.continue',
  group: 'review',
  title: () => t('review.continue'),
  when: () => review.isOpen && !look.isFixed && !review.recording?.cannot_continue,
  run: continueHere,
})
command({
  id: 'review.share',
  group: 'review',
  title: () => t('share.share'),
  when: () => review.isOpen && !look.isFixed && !review.isSharing,
  run: share,
})
command({
  id: 'review.close',
  group: 'review',
  title: () => t('review.close'),
  when: () => review.isOpen && !look.isFixed,
  run: closeRecording,
})
