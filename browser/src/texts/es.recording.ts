// Español: ejecuciones que se graban, que se continúan en el simulador, que se guardan como pruebas.
import type { enRecording } from './en.recording'

export const esRecording: Record<keyof typeof enRecording, string> = {
  'recording.record': 'Grabar',
  'recording.recordHint':
    'Guardar la ejecución en un archivo para verla después. Cuesta como mucho la vigésima parte de un núcleo.',
  'recording.recordOn': 'La próxima ejecución se graba',
  'recording.recordOff': 'La próxima ejecución no se graba',
  'recording.going': 'Grabando',
  'recording.goingHint': 'Esta ejecución se escribe en {path}',
  'recording.file': 'Grabada: {file} ({size})',
  'recording.gone': 'Grabada: {file}, que ya no está',
  'recording.look': 'Ver la grabación',
  'recording.keep': 'Guardar como prueba…',
  'recording.keepHint': 'Los cambios posteriores se comprueban con esta ejecución',

  'recording.simulator': 'Simulador',
  'recording.repeats': 'Repite la grabación hasta {n} s',
  'recording.repeatsHint': 'Hasta entonces es la ejecución grabada: se puede terminar, no dirigir.',
  'recording.goesOn': 'Simulada: la ejecución grabada hasta {n} s, y desde ahí sigue.',
  'recording.leave': 'Salir del simulador',
  'recording.leaveHint':
    'Termina el simulador con todo lo que vive en él e inicia el entorno de ejecución habitual, con la célula como al principio',

  'keep.title': 'Guardar {name} como prueba',
  'keep.about':
    'Se ejecuta {n} veces en simuladores, aparte: el robot no hace nada. Se anota lo que todas tienen en común, y «onika test» lo comprueba desde entonces.',
  'keep.name': 'Nombre',
  'keep.nameHint': 'un nombre, o la ruta de un archivo .test',
  'keep.expects': 'Al final',
  'keep.expectsHint': 'LAMP == 1',
  'keep.expectsWords': 'Lo que debe cumplirse cuando termina. Puede quedar vacío.',
  'keep.expectsOf': 'Lo que debe cumplirse al final, {n}',
  'keep.more': 'Añadir otra',
  'keep.begin': 'Guardar',
  'keep.again': 'Guardar de nuevo',
  'keep.close': 'Cerrar',
  'keep.beginning': 'Empezando',
  'keep.run': 'Ejecución {n} de {of}',
  'keep.goesOn': 'Puede cerrar esto. Se le avisará cuando termine.',
  'keep.kept': 'Guardada: {text}',
  'keep.failed': 'No se guardó',
  'keep.check': 'Compruébela con',
  'keep.other': 'Ahora se guarda {file}. Solo se guarda una prueba a la vez.',
}
