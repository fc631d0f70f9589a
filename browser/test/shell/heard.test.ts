// What the environment says, in Spanish where that is known.
import { expect, test } from 'vitest'
import { heard } from '../../src/texts/heard'

test('a sentence that is known is said in Spanish, with what varies in it', () => {
  // R-X01
  expect(heard('flow 2 is empty', 'es')).toBe('el flujo 2 está vacío')
  expect(heard('wave is done: 25 actions in 12.3 s', 'es')).toBe('wave ha terminado: 25 acciones en 12.3 s')
  expect(heard('New Joint target…', 'es')).toBe('Nuevo objetivo Joint…')
  expect(heard('Save and run', 'es')).toBe('Guardar y ejecutar')
})

test('what is a sentence within a sentence is told in Spanish too', () => {
  expect(heard('play was aborted after 1 action: aborted by the user', 'es')).toBe(
    'play se interrumpió tras 1 acción: interrumpida por el usuario',
  )
})

test('what is taken back is named in Spanish, also where another did it', () => {
  // R-X10
  expect(heard('deleting 8 icons', 'es')).toBe('borrar 8 iconos')
  expect(heard('“pasting waveC” in play was done on another page, and is done again here', 'es')).toBe(
    '«pegar waveC» en play se hizo en otra página, y aquí se rehace',
  )
})

test('a longer sentence that ends like a known one is not told half in Spanish', () => {
  const said = 'its data is asked for while it runs'
  expect(heard(said, 'es')).toBe(said)
})

test('what is not known stays as it was said, and English always does', () => {
  expect(heard('the sensor is dead', 'es')).toBe('the sensor is dead')
  expect(heard('flow 2 is empty', 'en')).toBe('flow 2 is empty')
})
