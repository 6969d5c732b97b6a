//! Rows of a picture in an OpenEXR file: the data window is the rows, the display window the whole picture, and a text
//! attribute says what else decides its bits (<https://openexr.com/en/latest/TechnicalIntroduction.html>).

use std::fs::File;
use std::io::{BufReader, Cursor};
use std::ops::Range;
use std::path::Path;

use exr::prelude::{
    AttributeValue, Compression, Encoding as FileEncoding, Image, IntegerBounds, Layer, LayerAttributes, MetaData,
    ReadChannels, ReadLayers, SampleType, SpecificChannels, Text, Vec2, WritableImage, read,
};
use whit::Rgb;
use whit::render::Size;

use crate::description::Description;

/// The attribute with the description.
const ATTRIBUTE: &str = "whit";
/// Nothing is lost, and other programs read it.
const FORMAT: FileEncoding = FileEncoding::SMALL_LOSSLESS;

/// Some or all rows of a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// The size of the whole picture.
    pub size: Size,
    pub rows: Range<u32>,
    pub description: Description,
}

impl Part {
    pub fn pixels(&self) -> usize {
        self.rows.len() * self.size.width as usize
    }

    /// A whole file.
    pub fn to_exr(&self, pixels: &[Rgb<f32>]) -> Result<Vec<u8>, String> {
        let width = self.size.width as usize;
        let color = |at: Vec2<usize>| pixels.get(at.y() * width + at.x()).map_or((0.0, 0.0, 0.0), |c| (c.r, c.g, c.b));
        let description = Text::new_or_none(self.description.to_json()).ok_or("the description is not plain text")?;
        let mut attributes = LayerAttributes::default().with_position(Vec2(0, self.rows.start as i32));
        attributes.other.insert(Text::from(ATTRIBUTE), AttributeValue::Text(description));
        let data_size = (width, self.rows.len());
        let mut image = Image::from_layer(Layer::new(data_size, attributes, FORMAT, SpecificChannels::rgb(color)));
        image.attributes.display_window = IntegerBounds::from_dimensions((width, self.size.height as usize));
        let mut file = Cursor::new(Vec::new());
        image.write().to_buffered(&mut file).map_err(|error| error.to_string())?;
        Ok(file.into_inner())
    }

    /// What a file says of itself; its pixels are not read.
    pub fn open(path: &Path) -> Result<Self, String> {
        let fault = |problem: &str| format!("{}: {problem}", path.display());
        if path.is_dir() {
            return Err(fault("is a folder"));
        }
        let file = File::open(path).map_err(|error| fault(&error.to_string()))?;
        let data = MetaData::read_from_buffered(BufReader::new(file), true)
            .map_err(|error| fault(&format!("is no OpenEXR file, or not all of one ({error})")))?;
        Self::from_header(&data).ok_or_else(|| fault("is no part: this tool did not write it, or not as it is"))
    }

    fn from_header(data: &MetaData) -> Option<Self> {
        let [header] = data.headers.as_slice() else { return None };
        let channels: Vec<_> = header.channels.list.iter().map(|one| (one.name.to_string(), one.sample_type)).collect();
        let expected = ["B", "G", "R"].map(|name| (name.to_owned(), SampleType::F32));
        let own = &header.own_attributes;
        let Some(AttributeValue::Text(description)) = own.other.get(&Text::from(ATTRIBUTE)) else { return None };
        let display = header.shared_attributes.display_window;
        let (size, rows) = (display.size, header.layer_size);
        let side = 1..=Size::LARGEST as usize;
        let in_place = display.position == Vec2(0, 0)
            && side.contains(&size.width())
            && side.contains(&size.height())
            && own.layer_position.x() == 0
            && rows.width() == size.width();
        let start = usize::try_from(own.layer_position.y()).ok()?;
        let end = start.checked_add(rows.height()).filter(|&end| start < end && end <= size.height())?;
        let as_written = header.compression == Compression::ZIP16 && channels == expected && in_place;
        as_written.then_some(Self {
            size: Size::new(size.width() as u32, size.height() as u32),
            rows: start as u32..end as u32,
            description: Description::from_json(&description.to_string())?,
        })
    }
}

/// The pixels of a part, row by row.
pub fn read_pixels(path: &Path) -> Result<Vec<Rgb<f32>>, String> {
    let create = |size: Vec2<usize>, _: &_| (size.width(), vec![Rgb::BLACK; size.area()]);
    let set = |(width, pixels): &mut (usize, Vec<Rgb<f32>>), at: Vec2<usize>, (r, g, b): (f32, f32, f32)| {
        if let Some(pixel) = pixels.get_mut(at.y() * *width + at.x()) {
            *pixel = Rgb::new(r, g, b);
        }
    };
    let image = read()
        .no_deep_data()
        .largest_resolution_level()
        .rgb_channels(create, set)
        .first_valid_layer()
        .all_attributes()
        .pedantic()
        .from_file(path)
        .map_err(|error| format!("{}: is not whole ({error})", path.display()))?;
    Ok(image.layer_data.channel_data.pixels.1)
}
